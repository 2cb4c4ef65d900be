#include "export/base64.hpp"

#include <string_view>

namespace zenosphere {

void Base64::write(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) {
    group_[size_++] = byte;
    if (size_ == group_.size()) write_group();
  }
}

void Base64::close() {
  if (size_ > 0) write_group();
}

void Base64::write_group() {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::uint32_t bits =
      std::uint32_t{group_[0]} << 16 | std::uint32_t{group_[1]} << 8 | std::uint32_t{group_[2]};
  std::array<char, 4> text{'=', '=', '=', '='};
  for (std::size_t n = 0; n <= size_; ++n) text[n] = letters[bits >> (18 - 6 * n) & 63];
  file_.write({text.data(), text.size()});
  group_ = {};
  size_ = 0;
}

}  // namespace zenosphere
