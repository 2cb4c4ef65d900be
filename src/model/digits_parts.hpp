#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "model/real.hpp"

namespace zenosphere {

enum class NumberKind : std::uint8_t { finite, infinite, not_a_number };

/// A Digits100 taken apart: (-1)^negative x 0.words x 2^exponent.
struct DigitsParts {
  NumberKind kind = NumberKind::finite;
  bool negative = false;
  std::int32_t exponent = 0;
  std::array<std::uint32_t, 11> words{};  ///< 334 bits are needed
};

/// Every number has one form: the first word of a finite one begins with a 1, but of 0.
inline DigitsParts parts_of(const Digits100& value) {
  DigitsParts parts{.negative = signbit(value) != 0};
  if (isnan(value) || isinf(value)) {
    parts.kind = isnan(value) ? NumberKind::not_a_number : NumberKind::infinite;
    return parts;
  }
  Digits100 rest = frexp(abs(value), &parts.exponent);
  if (rest > 0 && rest < 0.5) {  // Boost goes by the nearest double, which may be a power of two
    rest *= 2;
    --parts.exponent;
  }
  for (std::uint32_t& word : parts.words) {  // exact: only whole bits are taken away
    rest = ldexp(rest, 32);
    word = static_cast<std::uint32_t>(rest);
    rest -= word;
  }
  return parts;
}

/// The number that parts_of() took apart.
inline Digits100 composed(const DigitsParts& parts) {
  using Limits = std::numeric_limits<Digits100>;
  Digits100 value = 0;
  if (parts.kind == NumberKind::finite) {
    for (auto word = parts.words.rbegin(); word != parts.words.rend(); ++word) {
      value = ldexp(Digits100(value + *word), -32);
    }
    value = ldexp(value, parts.exponent);
  } else {
    value = parts.kind == NumberKind::infinite ? Limits::infinity() : Limits::quiet_NaN();
  }
  return parts.negative ? Digits100(-value) : value;
}

}  // namespace zenosphere
