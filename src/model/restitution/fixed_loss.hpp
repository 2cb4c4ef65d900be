#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "model/case_key.hpp"
#include "model/real.hpp"
#include "model/restitution/colliding_pair.hpp"

namespace zenosphere {

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
  /// At which `check` shows it, diameters/time.
  static constexpr std::array shown_speeds{1.0, 0.01};

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

/// That law as a case has it.
struct FixedLossLaw {
  static constexpr std::string_view word = "fixed-loss";
  double energy_loss = 0;  ///< of an energetic collision, mass diameter^2/time^2

  template <class Visitor>
  void keys(Visitor&& visit) {
    using namespace case_format;
    // Beyond every collision, and four times it is a number.
    visit(CaseKey{"energy_loss", required, above_to(0, 1e300),
                  "of each collision with more kinetic energy along its normal "
                  "[mass diameter^2/time^2]"},
          energy_loss);
  }

  template <class Real>
  FixedLossRestitution<Real> in() const {
    return FixedLossRestitution<Real>(from_decimal<Real>(energy_loss));
  }
};

}  // namespace zenosphere
