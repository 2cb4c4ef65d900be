#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "storage/new_file.hpp"

namespace zenosphere {

/// Writes bytes to a file in base64, as one text whatever the pieces in which they come.
class Base64 {
 public:
  /// \param file  outlives this
  explicit Base64(NewFile& file) : file_(file) {}

  void write(std::span<const std::uint8_t> bytes);
  /// Writes the rest. The last call.
  void close();

 private:
  NewFile& file_;
  std::vector<std::uint8_t> waiting_;
};

}  // namespace zenosphere
