#pragma once

#include <atomic>
#include <cmath>
#include <cstdint>
#include <span>

#include "proof/ball_spheres.hpp"
#include "proof/certificate.hpp"

namespace zenosphere {

/// How far a cluster is followed.
struct ClusterLimits {
  int decades = 100;  ///< of gap, at which it is enough
  std::int64_t collisions = 20000;
  long bits = 65536;  ///< of a number, at most; begins with 512 and doubles
  const std::atomic<bool>* interrupt = nullptr;
};

/// Follows the spheres of a cluster, alone, from one moment on in ball arithmetic.
///
/// `enclosed`: the order of all collisions until a gap below 10^-decades is certain, and the last
/// of them is at a time between `lower` and `upper`, since that moment; `word` is the round with
/// which they end. `escapes`: they certainly collide no more. `none`: not even the largest number
/// of bits tells the order (two at one instant), or the gaps do not fall within the limits;
/// `decades` is how far they did. This says what the model does *from the numbers given*: how well
/// those are known is the caller's matter, and so is that no other sphere comes near. Collapse
/// itself it does not prove (docs/decisions/0019).
///
/// \param spheres      two or more, all of one dimension, apart or just in contact; two that
/// overlap must
///                     recede (`none` otherwise)
/// \param restitution  in [0, 1]
/// Source: docs/decisions/0019.
Certificate enclose_cluster(std::span<const ExactSphere> spheres, const Rational& restitution,
                            const ClusterLimits& limits = {});

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
