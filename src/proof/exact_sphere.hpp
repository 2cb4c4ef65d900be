#pragma once

#include <cmath>
#include <vector>

#include "proof/rational.hpp"

namespace zenosphere {

/// A sphere of diameter and mass 1 at one moment, in 1, 2 or 3 dimensions, in numbers that are
/// exact.
struct ExactSphere {
  std::vector<Rational> position;  ///< diameters, in one image of the box
  std::vector<Rational> velocity;  ///< diameter/time, in one frame
};

/// A binary floating-point number of any kind, exactly; it is finite.
template <class Real>
Rational exactly(const Real& value) {
  using std::frexp;
  using std::ldexp;
  int exponent = 0;
  Real rest = frexp(value, &exponent);
  constexpr int kStep = 30;
  Integer digits;
  for (; rest != 0; exponent -= kStep) {
    rest = ldexp(rest, kStep);
    const long word = static_cast<long>(rest);
    rest -= Real(word);
    digits = (digits << kStep) + word;
  }
  Rational result(digits);
  if (exponent < 0) return result / Rational(Integer(1) << -exponent);
  return result * Rational(Integer(1) << exponent);
}

}  // namespace zenosphere
