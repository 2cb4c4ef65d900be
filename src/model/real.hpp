#pragma once

#include <boost/multiprecision/float128.hpp>
#include <charconv>
#include <cstdio>
#include <limits>
#include <string>
#include <type_traits>

#include "model/digits.hpp"

namespace zenosphere {

/// The number types of the engine beside `double` and Digits: the precision ladder.
using Extended = long double;                  ///< 64-bit significand
using Quad = boost::multiprecision::float128;  ///< 113-bit significand

/// Bits of the significand of Real; of Digits those of the working precision.
template <class Real>
int significand_bits() {
  if constexpr (std::is_same_v<Real, Digits>) {
    return WorkingPrecision::bits();
  } else {
    return std::numeric_limits<Real>::digits;
  }
}

/// The number that the shortest decimal text of `value` means, in the precision of Real.
///
/// A user who writes 0.05 means 1/20, not the `double` next to it: what a case file says is read in
/// the run's own precision. Texts of up to 15 digits come back as they were written.
template <class Real>
Real from_decimal(double value) {
  if constexpr (std::is_same_v<Real, double>) {
    return value;
  } else {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    const std::string decimal(text, end);
    if constexpr (std::is_same_v<Real, Extended>) {
      return std::stold(decimal);
    } else {
      return Real(decimal);
    }
  }
}

/// The `double` next to a number, or 5e-324, the least there is, for one above 0 that is smaller:
/// what is above 0 stays so in a file.
template <class Real>
double nearest_double(const Real& value) {
  const auto nearest = static_cast<double>(value);
  if constexpr (!std::is_same_v<Real, double>) {
    if (nearest == 0 && value > 0) return std::numeric_limits<double>::denorm_min();
  }
  return nearest;
}

/// A number as decimal text with all the digits that Real tells apart.
template <class Real>
std::string to_decimal(const Real& value) {
  if constexpr (std::is_same_v<Real, Digits>) {
    return value.str();
  } else if constexpr (std::is_floating_point_v<Real>) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*Lg", std::numeric_limits<Real>::max_digits10,
                  static_cast<Extended>(value));
    return text;
  } else {
    return value.str(std::numeric_limits<Real>::max_digits10);
  }
}

}  // namespace zenosphere
