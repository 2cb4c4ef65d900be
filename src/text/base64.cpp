#include "text/base64.hpp"

#include <algorithm>
#include <string_view>

namespace zenosphere {

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t n = 0; n < bytes.size(); n += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - n);
    std::uint32_t three = 0;
    for (std::size_t m = 0; m < 3; ++m) {
      three = three << 8 | (m < count ? std::uint32_t{bytes[n + m]} : 0U);
    }
    for (std::size_t m = 0; m < 4; ++m) {
      text += m <= count ? digits[three >> (18 - 6 * m) & 63] : '=';
    }
  }
  return text;
}

}  // namespace zenosphere
