#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "model/contact.hpp"
#include "model/oscillation.hpp"
#include "model/vec.hpp"

namespace zenosphere {

/// Two flat walls that close the box along one axis, and how spheres bounce off them. The lower one
/// may oscillate along the axis; either may be thermal.
template <class Real>
struct Walls {
  int axis = 0;                      ///< their normal
  Real restitution = 1;              ///< of the normal velocity, in [0, 1]
  Real tangential_restitution = -1;  ///< in [-1, 1]; -1: smooth, 0: takes the wall's velocity
  Real friction =
      std::numeric_limits<Real>::infinity();  ///< of spheres that turn: ContactConstants
  std::array<Real, 2> speed = {0, 0};  ///< of the lower and the upper wall along x, diameters/time
  std::optional<Oscillation<Real>> oscillation{};  ///< of the lower wall
  Real resting_flight = 0;  ///< of a sphere that rests on the oscillating wall, time; 0: none
  std::array<std::optional<Real>, 2> temperature{};  ///< of each, mass (diameter/time)^2; none: the
                                                     ///< restitution tells what it does
  std::uint64_t seed = 1;                            ///< of what thermal walls draw

  bool oscillates(int side) const { return side == 0 && oscillation; }
  bool is_thermal(int side) const {
    return temperature[static_cast<std::size_t>(side)].has_value();
  }
  /// Whether spheres may become faster by the walls alone.
  bool feed_energy() const {
    return oscillation || is_thermal(0) || is_thermal(1) || tangential_restitution != -1;
  }
};

/// What a wall does to a sphere that hits it.
template <int Dim, class Real>
struct WallImpact {
  Impact<Dim, Real> impact;  ///< the normal points from the sphere to the wall
  Vec<Dim, Real> change;     ///< of the momentum, normal and tangential, mass diameters/time
  bool rests = false;        ///< the sphere was let go at the least speed
};

/// A sphere as it hits one of the walls: no impulse yet.
///
/// \param side      0: lower, 1: upper wall
/// \param velocity  of the sphere, along the normal relative to the wall, diameters/time
template <int Dim, class Real>
Impact<Dim, Real> wall_meeting(const Walls<Real>& walls, int side, const Vec<Dim, Real>& velocity,
                               const Real& radius) {
  Impact<Dim, Real> impact;
  impact.normal[walls.axis] = side == 0 ? -1 : 1;
  impact.distance = radius;
  impact.normal_speed = dot(impact.normal, velocity);
  return impact;
}

/// The bounce of a sphere that does not turn off one of the walls.
///
/// The normal velocity is reversed and multiplied by the wall's restitution; the tangential
/// velocity relative to the wall is multiplied by minus the tangential restitution. A sphere that
/// recedes by rounding gets no impulse.
///
/// \param side      0: lower, 1: upper wall
/// \param velocity  of the sphere, along the normal relative to the wall, diameters/time
/// \param least     speed with which it is let go at least; 0: none
template <int Dim, class Real>
WallImpact<Dim, Real> wall_impact(const Walls<Real>& walls, int side,
                                  const Vec<Dim, Real>& velocity, const Real& mass = Real(1),
                                  const Real& radius = Real(0.5), const Real& least = Real(0)) {
  WallImpact<Dim, Real> result{wall_meeting(walls, side, velocity, radius), {}};
  Impact<Dim, Real>& impact = result.impact;
  impact.impulse = impact.normal_speed > 0
                       ? Real((1 + walls.restitution) * impact.normal_speed * mass)
                       : Real(0);
  if (least > 0 && impact.impulse / mass - impact.normal_speed < least) {
    impact.impulse = (impact.normal_speed + least) * mass;
    result.rests = true;
  }
  result.change = impact.normal * -impact.impulse;
  if (walls.tangential_restitution == -1 || impact.impulse == 0) return result;
  for (int axis = 0; axis < Dim; ++axis) {
    if (axis == walls.axis) continue;
    const Real wall_speed = axis == 0 ? walls.speed[static_cast<std::size_t>(side)] : Real(0);
    result.change[axis] = (1 + walls.tangential_restitution) * (wall_speed - velocity[axis]) * mass;
  }
  return result;
}

/// The bounce of a smooth sphere off a thermal wall, which gives it another velocity.
///
/// \param after  velocity that it gets, away from the wall along the axis
template <int Dim, class Real>
WallImpact<Dim, Real> thermal_impact(const Walls<Real>& walls, int side,
                                     const Vec<Dim, Real>& velocity, const Vec<Dim, Real>& after,
                                     const Real& mass = Real(1), const Real& radius = Real(0.5)) {
  Impact<Dim, Real> impact = wall_meeting(walls, side, velocity, radius);
  const Vec<Dim, Real> change = (after - velocity) * mass;
  impact.impulse = -dot(impact.normal, change);
  return {impact, change};
}

/// Speed at which a gap closes that shrinks, or falls back, at a constant acceleration.
///
/// From the energy of the fall, not from its rounded duration: a bouncing ball whose flights have
/// come down to a few units in the last place of the clock would gain speed from the rounding.
template <class Real>
Real closing_speed(const Real& gap, const Real& rate, const Real& acceleration) {
  using std::sqrt;
  const Real square = rate * rate - 2 * acceleration * gap;
  return square > 0 ? Real(sqrt(square)) : Real(0);
}

/// How wide a gap gets before it closes that changes at `rate` and with a constant `acceleration`:
/// where it opens and falls back, the height of the apex.
template <class Real>
Real widest_gap(const Real& gap, const Real& rate, const Real& acceleration) {
  if (!(rate > 0) || !(acceleration < 0)) return gap;
  return gap + rate * rate / (-2 * acceleration);
}

/// Time until a gap closes that changes at `rate` and with a constant `acceleration`.
///
/// Solves gap + rate t + acceleration t^2/2 = 0 for the moment at which the gap closes: the earlier
/// root if it shrinks, the later one if it opens and falls back. No difference of nearly equal
/// numbers is taken. A negative gap that shrinks gives a time <= 0, as a pair of spheres does; one
/// that opens too slowly ever to become positive closes when it begins to shrink.
///
/// \return  time from now, or nothing if the gap never closes
template <class Real>
std::optional<Real> closing_time(const Real& gap, const Real& rate, const Real& acceleration) {
  using std::sqrt;
  if (acceleration == 0) {
    if (!(rate < 0)) return std::nullopt;
    return gap / -rate;
  }
  const Real discriminant = rate * rate - 2 * acceleration * gap;
  if (rate < 0) {
    if (discriminant < 0) {
      if (gap > 0) return std::nullopt;  // turns back before it is closed
      return Real(0);                    // never was open: it is due
    }
    return 2 * gap / (sqrt(discriminant) - rate);
  }
  if (acceleration > 0) return std::nullopt;
  return (rate + sqrt(discriminant > 0 ? discriminant : Real(0))) / -acceleration;
}

}  // namespace zenosphere
