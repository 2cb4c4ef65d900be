#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace zenosphere {

enum class NumberKind : std::uint8_t { finite, infinite, not_a_number };

/// A number taken apart: (-1)^negative x 0.words x 2^exponent.
struct DigitsParts {
  NumberKind kind = NumberKind::finite;
  bool negative = false;
  std::int32_t exponent = 0;
  std::vector<std::uint32_t> words{};  ///< as many as its bits fill; the first begins with a 1, or
                                       ///< all are 0
};

/// How many words a significand of so many bits fills.
constexpr std::size_t words_of_bits(int bits) { return static_cast<std::size_t>((bits + 31) / 32); }

}  // namespace zenosphere
