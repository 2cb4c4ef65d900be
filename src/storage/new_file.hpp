#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "storage/durable.hpp"

namespace zenosphere {

/// A new file, or standard output, written from its beginning to its end in blocks of 1 MiB.
///
/// Every function throws OutputError with the name under which the user knows the file.
class NewFile {
 public:
  struct StandardOutput {};
  static constexpr StandardOutput standard_output{};

  /// \param path   where it is made; nothing may be there
  /// \param shown  its name in messages
  NewFile(const std::filesystem::path& path, const std::filesystem::path& shown);

  explicit NewFile(StandardOutput);

  void write(std::string_view text);
  /// Returns once everything written is on the disk, or has left for standard output.
  void close();

 private:
  void flush();

  std::filesystem::path shown_;
  std::optional<FileDescriptor> file_;  ///< none: standard output
  std::vector<std::uint8_t> buffer_;
  std::uint64_t size_ = 0;  ///< written to the system, bytes
};

}  // namespace zenosphere
