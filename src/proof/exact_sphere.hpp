#pragma once

#include <cmath>
#include <vector>

#include "proof/rational.hpp"

namespace zenosphere {

/// A smooth sphere at one moment, in 1, 2 or 3 dimensions, in numbers that are exact.
struct ExactSphere {
  std::vector<Rational> position;  ///< diameters, in one image of the box
  std::vector<Rational> velocity;  ///< diameter/time, in one frame
  Rational radius{1, 2};           ///< > 0, diameters
  Rational mass{1};                ///< > 0
};

/// The restitution of each two of some spheres, a row for each; symmetric, all in [0, 1].
struct PairRestitutions {
  std::vector<std::vector<Rational>> rows;

  /// The same of all.
  PairRestitutions(std::size_t spheres, const Rational& restitution)
      : rows(spheres, std::vector<Rational>(spheres, restitution)) {}
};

/// A binary floating-point number of any kind, exactly; it is finite.
template <class Real>
Rational exactly(const Real& value) {
  using std::frexp;
  using std::ldexp;
  int exponent = 0;
  Real rest = frexp(value, &exponent);
  constexpr int bits_a_step = 30;
  Integer digits;
  for (; rest != 0; exponent -= bits_a_step) {
    rest = ldexp(rest, bits_a_step);
    const long word = static_cast<long>(rest);
    rest -= Real(word);
    digits = (digits << bits_a_step) + word;
  }
  Rational result(digits);
  if (exponent < 0) return result / Rational(Integer(1) << -exponent);
  return result * Rational(Integer(1) << exponent);
}

}  // namespace zenosphere
