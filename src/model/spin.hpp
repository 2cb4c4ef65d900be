#pragma once

#include "model/vec.hpp"

namespace zenosphere {

/// Axes about which a sphere turns: three in space, one across the plane. On a line nothing turns,
/// and vectors of spins are empty.
template <int Dim>
inline constexpr int spin_axes = Dim == 3 ? 3 : 1;

/// An angular velocity, radians/time.
template <int Dim, class Real>
using Spin = Vec<spin_axes<Dim>, Real>;

/// Velocity of a point of a turning sphere, spin x arm.
///
/// \param arm  from the centre to the point
template <int Dim, class Real>
Vec<Dim, Real> turning_velocity(const Spin<Dim, Real>& spin, const Vec<Dim, Real>& arm) {
  if constexpr (Dim == 3) {
    return {spin[1] * arm[2] - spin[2] * arm[1], spin[2] * arm[0] - spin[0] * arm[2],
            spin[0] * arm[1] - spin[1] * arm[0]};
  } else if constexpr (Dim == 2) {
    return {-spin[0] * arm[1], spin[0] * arm[0]};
  } else {
    return {};
  }
}

/// Angular impulse about the centre, arm x impulse.
template <int Dim, class Real>
Spin<Dim, Real> angular_impulse(const Vec<Dim, Real>& arm, const Vec<Dim, Real>& impulse) {
  if constexpr (Dim == 3) {
    return {arm[1] * impulse[2] - arm[2] * impulse[1], arm[2] * impulse[0] - arm[0] * impulse[2],
            arm[0] * impulse[1] - arm[1] * impulse[0]};
  } else if constexpr (Dim == 2) {
    return {arm[0] * impulse[1] - arm[1] * impulse[0]};
  } else {
    return {};
  }
}

/// q of a solid sphere or disk, whose moment of inertia is q mass diameter^2 / 4.
template <int Dim>
inline constexpr double solid_inertia = Dim == 3 ? 0.4 : 0.5;

}  // namespace zenosphere
