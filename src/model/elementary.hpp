#pragma once

#include <cmath>

namespace zenosphere {

// Elementary functions from additions, products and quotients only. The C library picks its
// versions by processor, and their last bits may differ; a run must be the same on every machine.

/// The fifth root of x >= 0, good to a few units in the last place of Real.
///
/// Newton's steps fall towards the root of y^5 = x from above and end when they no longer fall.
template <class Real>
Real fifth_root(const Real& x) {
  using std::frexp;
  using std::ldexp;
  if (!(x > 0)) return Real(0);
  int exponent = 0;
  Real rest = frexp(x, &exponent);  // in [1/2, 1); Boost's may be a hair below
  for (; exponent % 5 != 0; --exponent) rest *= 2;
  Real root = 2;  // above every root of a number below 2^5
  for (;;) {
    const Real fourth = (root * root) * (root * root);
    const Real next = root - (root - rest / fourth) / 5;
    if (!(next < root)) return ldexp(root, exponent / 5);
    root = next;
  }
}

/// The exponential of x, good to a few ulps; 0 where it would be below 1e-300.
///
/// e^x = 2^n e^r with |r| <= ln 2 / 2, and e^r by its power series.
///
/// \param x  <= 700
inline double portable_exp(double x) {
  if (x < -690) return 0;
  constexpr double ln2_high = 0x1.62e42fefa38p-1;  // 42 bits: n times it is exact
  constexpr double ln2_low = 0x1.ef35793c7673p-45;
  const double n = std::nearbyint(x / ln2_high);
  const double r = (x - n * ln2_high) - n * ln2_low;
  double sum = 1;
  for (int k = 14; k >= 1; --k) sum = 1 + sum * r / k;  // 0.35^15 / 15! = 1e-19
  return std::ldexp(sum, static_cast<int>(n));
}

/// Sine and cosine of an angle.
template <class Real>
struct SineAndCosine {
  Real sine;
  Real cosine;
};

/// Sine and cosine by their power series, good to a few ulps of 1 for |angle| <= pi/2 (radians).
template <class Real>
SineAndCosine<Real> sine_and_cosine(const Real& angle) {
  SineAndCosine<Real> result{angle, 1};
  Real term = angle;  // angle^n / n!, with the sign of the series
  for (int n = 2;; n += 2) {
    term *= -angle / n;
    const Real cosine = result.cosine + term;
    term /= n + 1;
    term *= angle;
    const Real sine = result.sine + term;
    if (sine == result.sine && cosine == result.cosine) return result;
    result = {sine, cosine};
  }
}

}  // namespace zenosphere
