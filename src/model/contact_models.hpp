#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "model/elementary.hpp"

namespace zenosphere {

/// What a law of restitution has to know of two spheres beside their speed; by default of two unit
/// spheres.
template <class Real>
struct CollidingPair {
  Real inverse_masses = 2;  ///< 1/m_i + 1/m_j > 0, 1/mass
  Real diameter = 1;        ///< of equal spheres as curved at the contact, 2 s_i s_j / (s_i + s_j)
};

/// Coefficient of restitution of two viscoelastic spheres: softer blows are more elastic.
///
/// With x = sqrt(A v^(1/5)) the restitution is (1 + b1 x) / (1 + b1 x + b2 x^2 + b3 x^3 + b4 x^4),
/// which has the series 1 - C1 x^2 + (3/5) C1^2 x^4 - (4/15) x^5 ... in common with the collision
/// of two viscoelastic spheres up to that term, falls from 1 at rest towards 0, and lies within
/// 0.008 of the integrated equation of motion at every speed.
///
/// A is that of two unit spheres. For others of the same material it is to be multiplied by
/// (sqrt(R) / m)^(2/5), R and m the reduced radius and mass in units of those of unit spheres. That
/// is as if they met at the speed v R / m^2.
///
/// Source: equation of motion and series, Ramirez et al., Phys. Rev. E 60 (1999) 4465; the term
/// x^5 (spheres part before they have regained their shape), Schwager & Poeschel, Phys. Rev. E 78
/// (2008) 051304; the quotient, Mueller & Poeschel, Phys. Rev. E 84 (2011) 021302.
template <class Real>
class ViscoelasticRestitution {
 public:
  /// \param constant  A > 0 of two unit spheres, (time/diameter)^(1/5)
  explicit ViscoelasticRestitution(const Real& constant) : constant_(constant) {}

  /// \param normal_speed  closing speed > 0, diameters/time
  /// \param pair          sizes and masses
  /// \return              in [0, 1]
  Real operator()(const Real& normal_speed, const CollidingPair<Real>& pair = {}) const {
    using std::sqrt;
    const Real lightness = pair.inverse_masses / 2;
    const Real speed = normal_speed * (lightness * lightness * pair.diameter);
    const Real x = sqrt(static_cast<Real>(constant_ * fifth_root(speed)));
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
/// Where the kinetic energy of their normal motion, m_n v^2/2 with the reduced mass m_n, exceeds
/// the loss, the collision takes exactly the loss: the restitution is sqrt(1 - c^2/v^2), c^2 = 2
/// loss / m_n, for two unit masses 4 loss. A weaker collision is elastic. So a collapse, in which
/// the speeds fall without end, cannot begin.
///
/// Source: spheres that lose a fixed energy, Dolmaire & Velazquez, arXiv 2403.02162 (2024); that it
/// is taken from the normal motion alone is what smooth spheres need.
template <class Real>
class FixedLossRestitution {
 public:
  /// \param loss  > 0, mass diameter^2/time^2
  explicit FixedLossRestitution(const Real& loss) : of_unit_masses_(two_roots(loss)) {}

  /// \param normal_speed  closing speed > 0, diameters/time
  /// \param pair          masses
  /// \return              in (0, 1]; 1 up to and at the threshold
  Real operator()(const Real& normal_speed, const CollidingPair<Real>& pair = {}) const {
    using std::sqrt;
    const Real threshold = this->threshold(pair);
    if (!(normal_speed > threshold)) return Real(1);
    // The quotient of speeds neither overflows nor underflows, and a difference keeps its digits.
    const Real share = threshold / normal_speed;
    const Real rest = (normal_speed - threshold) / normal_speed;
    return sqrt(static_cast<Real>(rest * (1 + share)));
  }

  /// The closing speed at which the loss is all of the kinetic energy, diameters/time.
  Real threshold(const CollidingPair<Real>& pair = {}) const {
    using std::sqrt;
    return Real(of_unit_masses_ * sqrt(static_cast<Real>(pair.inverse_masses / 2)));
  }

 private:
  static Real two_roots(const Real& loss) {
    using std::sqrt;
    return Real(2 * sqrt(loss));
  }

  Real of_unit_masses_;  ///< their threshold
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
