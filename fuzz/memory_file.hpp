#pragma once

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>

namespace zenosphere::fuzz {

/// A file with the given content for readers that want a path, in memory where there is /dev/shm;
/// gone with this object.
class MemoryFile {
 public:
  explicit MemoryFile(std::span<const std::uint8_t> bytes) {
    std::ofstream stream(path_, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(bytes.data()),
                 static_cast<std::streamsize>(bytes.size()));
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }

  const std::filesystem::path& path() const { return path_; }

 private:
  static std::filesystem::path name() {
    const std::filesystem::path memory = "/dev/shm";
    std::error_code ignored;
    const bool is_there = std::filesystem::is_directory(memory, ignored);
    const auto folder = is_there ? memory : std::filesystem::temp_directory_path();
    return folder / ("zenosphere-fuzz-" + std::to_string(getpid()));
  }

  std::filesystem::path path_ = name();
};

}  // namespace zenosphere::fuzz
