#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/durable.hpp"

namespace zenosphere {

/// A new file, written from its beginning to its end in blocks of 1 MiB.
///
/// Every function throws OutputError with the name under which the user knows the file.
class NewFile {
 public:
  /// \param path   where it is made; nothing may be there
  /// \param shown  its name in messages
  NewFile(const std::filesystem::path& path, const std::filesystem::path& shown);

  void write(std::string_view text);
  /// Returns once everything written is on the disk.
  void close();

 private:
  void flush();

  std::filesystem::path shown_;
  FileDescriptor file_;
  std::vector<std::uint8_t> buffer_;
  std::uint64_t size_ = 0;  ///< written to the system, bytes
};

}  // namespace zenosphere
