#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "model/elementary.hpp"

namespace zenosphere {

/// Coefficient of restitution of two viscoelastic spheres: softer blows are more elastic.
///
/// With x = sqrt(A v^(1/5)) the restitution is (1 + b1 x) / (1 + b1 x + b2 x^2 + b3 x^3 + b4 x^4),
/// which has the series 1 - C1 x^2 + (3/5) C1^2 x^4 - (4/15) x^5 ... in common with the collision
/// of two viscoelastic spheres up to that term, falls from 1 at rest towards 0, and lies within
/// 0.008 of the integrated equation of motion at every speed.
///
/// Source: equation of motion and series, Ramirez et al., Phys. Rev. E 60 (1999) 4465; the term
/// x^5 (spheres part before they have regained their shape), Schwager & Poeschel, Phys. Rev. E 78
/// (2008) 051304; the quotient, Mueller & Poeschel, Phys. Rev. E 84 (2011) 021302.
template <class Real>
class ViscoelasticRestitution {
 public:
  /// \param constant  A > 0, (time/diameter)^(1/5)
  explicit ViscoelasticRestitution(const Real& constant) : constant_(constant) {}

  /// \param normal_speed  closing speed > 0, diameters/time
  /// \return              in [0, 1]
  Real operator()(const Real& normal_speed) const {
    using std::sqrt;
    const Real x = sqrt(static_cast<Real>(constant_ * fifth_root(normal_speed)));
    const Real numerator = 1 + b1_ * x;
    return numerator / (numerator + x * x * (b2_ + x * (b3_ + x * b4_)));
  }

 private:
  Real constant_;
  // C1 = sqrt(pi) Gamma(3/5) / (2^(1/5) 5^(2/5) Gamma(21/10)), the same number in every precision;
  // the others follow from the series above, and round to those of Mueller & Poeschel.
  Real b2_ = Real(1.1534488580952884);
  Real b4_ = 2 * b2_ * b2_ / 5;
  Real b1_ = 4 / (15 * b4_);
  Real b3_ = b1_ * b2_;
};

/// Coefficient of restitution of two spheres that lose a fixed energy in each energetic collision.
///
/// Where the kinetic energy of their normal motion, v^2/4 for two unit masses, exceeds the loss,
/// the collision takes exactly the loss: the restitution is sqrt(1 - c^2/v^2), c^2 = 4 loss. A
/// weaker collision is elastic. So a collapse, in which the speeds fall without end, cannot begin.
///
/// Source: spheres that lose a fixed energy, Dolmaire & Velazquez, arXiv 2403.02162 (2024); that it
/// is taken from the normal motion alone is what smooth spheres need.
template <class Real>
class FixedLossRestitution {
 public:
  /// \param loss  > 0, mass diameter^2/time^2
  explicit FixedLossRestitution(const Real& loss) : threshold_(two_roots(loss)) {}

  /// \param normal_speed  closing speed > 0, diameters/time
  /// \return              in (0, 1]; 1 up to and at the threshold 2 sqrt(loss)
  Real operator()(const Real& normal_speed) const {
    using std::sqrt;
    if (!(normal_speed > threshold_)) return Real(1);
    // The quotient of speeds neither overflows nor underflows, and a difference keeps its digits.
    const Real share = threshold_ / normal_speed;
    const Real rest = (normal_speed - threshold_) / normal_speed;
    return sqrt(static_cast<Real>(rest * (1 + share)));
  }

 private:
  static Real two_roots(const Real& loss) {
    using std::sqrt;
    return Real(2 * sqrt(loss));
  }

  Real threshold_;
};

/// Coefficient of restitution of two spheres that has one value below a speed and another one from
/// there on.
///
/// Source: Kikuchi, Kobayashi & Takada, arXiv 2603.19605 (2026).
template <class Real>
struct TwoValuedRestitution {
  Real slow;       ///< in [0, 1]
  Real fast;       ///< in [0, 1]
  Real threshold;  ///< > 0, diameters/time

  /// \param normal_speed  closing speed > 0, diameters/time
  Real operator()(const Real& normal_speed) const { return normal_speed < threshold ? slow : fast; }
};

/// What a collision of two spheres does beyond a constant restitution. Each model is apart from the
/// others, and they combine.
template <class Real>
struct ContactModels {
  /// In the place of the constant restitution; at most one of them.
  std::optional<ViscoelasticRestitution<Real>> viscoelastic{};
  std::optional<FixedLossRestitution<Real>> fixed_loss{};
  std::optional<TwoValuedRestitution<Real>> two_valued{};
  /// TC model: a collision of a sphere whose last one was less than this ago is elastic; 0: never.
  /// Source: Luding & McNamara, Granular Matter 1 (1998) 113.
  Real contact_duration = 0;
  /// The relative velocity after a collision is turned by a random angle up to this, radians; 0: it
  /// is not. Source: Deltour & Barrat, J. Phys. I 7 (1997) 137.
  Real rotation_angle = 0;
  std::uint64_t seed = 1;  ///< of the random angles

  bool is_any() const {
    return viscoelastic || fixed_loss || two_valued || contact_duration > 0 || rotation_angle > 0;
  }
};

}  // namespace zenosphere
