#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "export/new_file.hpp"

namespace zenosphere {

/// Writes bytes to a file in base64, as one text whatever the pieces in which they come.
/// Source: RFC 4648, section 4.
class Base64 {
 public:
  /// \param file  outlives this
  explicit Base64(NewFile& file) : file_(file) {}

  void write(std::span<const std::uint8_t> bytes);
  /// Writes what is left of the last three bytes, padded with `=`.
  void close();

 private:
  void write_group();

  NewFile& file_;
  std::array<std::uint8_t, 3> group_{};
  std::size_t size_ = 0;
};

}  // namespace zenosphere
