#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "model/case_key.hpp"
#include "model/elementary.hpp"
#include "model/real.hpp"
#include "model/restitution/colliding_pair.hpp"

namespace zenosphere {

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
  /// At which `check` shows it, diameters/time.
  static constexpr std::array shown_speeds{1.0, 0.01};

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

/// That law as a case has it.
struct ViscoelasticLaw {
  static constexpr std::string_view word = "viscoelastic";
  double viscoelastic_constant = 0;  ///< A, (time/diameter)^(1/5)

  template <class Visitor>
  void keys(Visitor&& visit) {
    using namespace case_format;
    // Every collision faster than 1e-100 is wholly inelastic then.
    visit(CaseKey{"viscoelastic_constant", required, above_to(0, 1e100),
                  "A in e = 1 - C1 A v^(1/5) + ... [(time/diameter)^(1/5)]"},
          viscoelastic_constant);
  }

  template <class Real>
  ViscoelasticRestitution<Real> in() const {
    return ViscoelasticRestitution<Real>(from_decimal<Real>(viscoelastic_constant));
  }
};

}  // namespace zenosphere
