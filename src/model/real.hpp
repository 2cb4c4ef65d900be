#pragma once

#include <boost/multiprecision/float128.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <charconv>
#include <cstdio>
#include <limits>
#include <string>
#include <type_traits>

namespace zenosphere {

/// The number types of the engine beside `double`: the precision ladder.
using Extended = long double;                  ///< 64-bit significand
using Quad = boost::multiprecision::float128;  ///< 113-bit significand

/// 100 decimal digits, 334-bit significand, by MPFR.
using Digits100 = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<100, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

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

/// A number as decimal text with all the digits that Real tells apart.
template <class Real>
std::string to_decimal(const Real& value) {
  constexpr int digits = std::numeric_limits<Real>::max_digits10;
  if constexpr (std::is_floating_point_v<Real>) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*Lg", digits, static_cast<Extended>(value));
    return text;
  } else {
    return value.str(digits);
  }
}

}  // namespace zenosphere
