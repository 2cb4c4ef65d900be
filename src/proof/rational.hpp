#pragma once

#include <gmpxx.h>

#include <string>

namespace zenosphere {

using Integer = mpz_class;
using Rational = mpq_class;

/// The number that a text means, exactly: "0.05" is 1/20, "-1.5e-3", "40/11".
///
/// \throws InputError  for what is no number, and for exponents beyond +-100000
Rational exact_number(const std::string& text);

/// A decimal text with `places` digits after the point, at most `value`; or at least `value`.
std::string decimal_below(const Rational& value, int places);
std::string decimal_above(const Rational& value, int places);

/// How many digits after the point tell the two ends of an interval of this width apart, and one
/// more. The width is positive.
int places_for(const Rational& width);

/// The integer part of log10(value), rounded downwards within one; value > 0 of any size.
int decimal_exponent(const Rational& value);

}  // namespace zenosphere
