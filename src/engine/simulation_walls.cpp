// Spheres and walls: when they meet, and what the contact does.

#include <algorithm>
#include <cmath>

#include "engine/simulation.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim, class Real>
NextMeetings<Real> Simulation<Dim, Real>::with_walls(std::int32_t i) {
  ahead_.clear();
  const int axis = surroundings_.walls->axis;
  for (const int wall : {0, 1}) {
    if (surroundings_.walls->oscillates(wall)) continue;
    const Real outward = wall == 0 ? -1 : 1;
    const Real gap = wall_gap(i, wall, now_.remainder);
    const Real rate = -outward * spheres_[i].velocity[axis];
    const auto time = closing_time<Real>(gap, rate, -outward * surroundings_.acceleration[axis]);
    if (time) ahead_.add(spheres() + wall, {*time, gap < 0 && *time <= 0, rate});
  }
  NextMeetings<Real> next = first_ahead(i);
  if (!surroundings_.walls->oscillation) return next;
  const Meeting<Real> meeting = with_oscillating_wall(i);
  if (meeting.is_with_anybody()) next.add(meeting);
  return next;
}

/// The next meeting with the wall that oscillates, or the moment at which it has to be looked for
/// again: where the sphere comes within reach of the wall, or has not met it in a period.
template <int Dim, class Real>
Meeting<Real> Simulation<Dim, Real>::with_oscillating_wall(std::int32_t i) const {
  constexpr std::uint32_t to_be_looked_at_again = 1;
  const auto& oscillation = *surroundings_.walls->oscillation;
  const std::int32_t wall = spheres();
  const int axis = surroundings_.walls->axis;
  const Real reach = OscillationGap<Real>::out_of_reach(oscillation);
  const Real clearance = wall_place(i, now_.remainder) - 2 * oscillation.amplitude();
  if (clearance > reach) {
    const auto time = closing_time<Real>(clearance - reach / 2, spheres_[i].velocity[axis],
                                         surroundings_.acceleration[axis]);
    if (!time) return {};
    return {now_.remainder + *time, wall, to_be_looked_at_again, false};
  }
  const auto [gap, from] = oscillating_gap(i);
  const Real since = now_.remainder - from;
  const auto due = gap.due(since);
  const bool overlaps = due.is_contact && !(due.span > since) && gap.at(since).gap < 0;
  return {from + due.span, wall, due.is_contact ? 0 : to_be_looked_at_again, overlaps};
}

/// The gap of a sphere to the wall that oscillates: counted from its last bounce off it, where no
/// other collision has come since, else from where the sphere is stored.
template <int Dim, class Real>
typename Simulation<Dim, Real>::CountedGap Simulation<Dim, Real>::oscillating_gap(
    std::int32_t i) const {
  const auto& oscillation = *surroundings_.walls->oscillation;
  const int axis = surroundings_.walls->axis;
  const Real& acceleration = surroundings_.acceleration[axis];
  const auto& sphere = spheres_[i];
  const auto& departure = moving_walls_->departure(i);
  if (departure.collisions != 0 && departure.collisions == sphere.collisions) {
    const Real phase = moving_walls_->phase(departure.time);
    const Real from = departure.time.remainder +
                      (static_cast<Real>(departure.time.units) - static_cast<Real>(now_.units)) *
                          box().clock_unit();
    return {{oscillation, phase, Real(0), departure.speed, acceleration}, from};
  }
  const Real phase = moving_walls_->phase({now_.units, sphere.time});
  const auto state = oscillation.at(phase);
  return {{oscillation, phase, wall_place(i, sphere.time) - state.height,
           sphere.velocity[axis] - state.speed, acceleration},
          sphere.time};
}

/// The collision of a sphere with a wall.
template <int Dim, class Real>
void Simulation<Dim, Real>::bounce(Collision<Dim, Real>& collision, int wall) {
  const Walls<Real>& walls = *surroundings_.walls;
  auto& sphere = spheres_[collision.i];
  Real least = 0;
  if (walls.oscillates(wall)) {
    least = touch_oscillating_wall(collision.i);
  } else {
    touch_wall(collision.i, wall);
  }
  const Vector before = sphere.velocity;
  Vector velocity = frame_.moves() ? sphere.velocity + frame_.velocity(now_) : sphere.velocity;
  ++sphere.collisions;
  if (walls.oscillates(wall)) velocity[walls.axis] = moving_walls_->departure(collision.i).speed;
  bool turns = false;
  if (walls.is_thermal(wall)) {
    const Real mass = grains().mass(collision.i);
    const Vector after = moving_walls_->thermal_velocity(walls, wall, mass);
    const auto bounce = thermal_impact(walls, wall, velocity, after, mass, radius(collision.i));
    collision.impact = bounce.impact;
    collision.change = bounce.change;
    sphere.velocity = frame_.moves() ? after - frame_.velocity(now_) : after;
  } else if (law_) {
    law_->bounce(collision, walls, wall, velocity, {grains(), spins()}, least);
    sphere.velocity += collision.change * grains().inverse_mass(collision.i);
    turns = turn(collision, collision.i);
  } else {
    const auto bounce = wall_impact(walls, wall, velocity, Real(1), Real(0.5), least);
    collision.impact = bounce.impact;
    collision.change = bounce.change;
    collision.resting = bounce.rests;
    sphere.velocity += collision.change;
  }
  collision.absorbed = sphere.velocity == before && !turns;
  if (walls.oscillates(wall)) depart(collision, least);
}

/// Stores a sphere as it touches a wall. Its place is known exactly then, half a diameter from the
/// wall, and so is its speed after a fall: neither is left to rounding.
template <int Dim, class Real>
void Simulation<Dim, Real>::touch_wall(std::int32_t i, int wall) {
  const Walls<Real>& walls = *surroundings_.walls;
  auto& sphere = spheres_[i];
  const Real outward = wall == 0 ? -1 : 1;
  const Real acceleration = -outward * surroundings_.acceleration[walls.axis];
  Real& velocity = sphere.velocity[walls.axis];
  const Real speed =
      closing_speed<Real>(wall_gap(i, wall, sphere.time), -outward * velocity, acceleration);
  spheres_.advance(sphere, now_.remainder);
  const Real radius = this->radius(i);
  sphere.position[walls.axis] = wall == 0 ? radius : Real(box().sides()[walls.axis] - radius);
  if (acceleration != 0) velocity = outward * speed;
}

/// The same at the wall that oscillates. Its departure becomes the arrival, with the speed relative
/// to the wall.
///
/// \return  the speed with which it has to be let go at least if the wall holds it
template <int Dim, class Real>
Real Simulation<Dim, Real>::touch_oscillating_wall(std::int32_t i) {
  const Walls<Real>& walls = *surroundings_.walls;
  auto& sphere = spheres_[i];
  const auto [gap, from] = oscillating_gap(i);
  const auto arrival = gap.at(now_.remainder - from);
  const Real rate = -closing_speed(arrival.gap, arrival.rate, arrival.acceleration);
  const auto state = walls.oscillation->at(moving_walls_->phase(now_));
  spheres_.advance(sphere, now_.remainder);
  sphere.position[walls.axis] = radius(i) + state.height;
  sphere.velocity[walls.axis] = state.speed + rate;
  moving_walls_->departure(i) = {now_, rate, sphere.collisions};
  const Real pull = state.acceleration - surroundings_.acceleration[walls.axis];
  return pull > 0 ? Real(pull * walls.resting_flight / 2) : Real(0);
}

/// Notes how a sphere leaves the wall that oscillates.
///
/// \param least  with which it is let go at least
template <int Dim, class Real>
void Simulation<Dim, Real>::depart(const Collision<Dim, Real>& collision, const Real& least) {
  auto& departure = moving_walls_->departure(collision.i);
  const Real mass = grains().mass(collision.i);
  const Real speed = collision.impact.impulse / mass - collision.impact.normal_speed;
  departure.speed = collision.resting ? least : speed;
  departure.collisions = spheres_[collision.i].collisions;
}

/// Place of a sphere's surface above where the lower wall is, or is at its lowest, diameters.
template <int Dim, class Real>
Real Simulation<Dim, Real>::wall_place(std::int32_t i, const Real& when) const {
  return spheres_.position_at(spheres_[i], when)[surroundings_.walls->axis] - radius(i);
}

/// Surface distance to a wall, diameters.
template <int Dim, class Real>
Real Simulation<Dim, Real>::wall_gap(std::int32_t i, int wall, const Real& when) const {
  if (surroundings_.walls->oscillates(wall)) {
    const auto [gap, from] = oscillating_gap(i);
    return gap.at(when - from).gap;
  }
  const int axis = surroundings_.walls->axis;
  const Real place = spheres_.position_at(spheres_[i], when)[axis];
  const Real radius = this->radius(i);
  return wall == 0 ? place - radius : (box().sides()[axis] - radius) - place;
}

/// How wide the gap to a wall gets from a moment on until it closes: off a wall and back to it the
/// height of the apex. If the wall oscillates, the wider one of the gaps then and half-way.
template <int Dim, class Real>
Real Simulation<Dim, Real>::widest_wall_gap(std::int32_t i, int wall, const Real& from,
                                            const Real& contact) const {
  if (surroundings_.walls->oscillates(wall)) {
    const auto [gap, start] = oscillating_gap(i);
    const Real half_way = (contact - start) / 2 + (from - start) / 2;
    return std::max(gap.at(from - start).gap, gap.at(half_way).gap);
  }
  const int axis = surroundings_.walls->axis;
  const Real outward = wall == 0 ? -1 : 1;
  return widest_gap<Real>(wall_gap(i, wall, from),
                          -outward * spheres_.velocity_at(spheres_[i], from)[axis],
                          -outward * surroundings_.acceleration[axis]);
}

template <int Dim, class Real>
Vec<Dim, Real> Simulation<Dim, Real>::wall_velocity(int side) const {
  const Walls<Real>& walls = *surroundings_.walls;
  Vector velocity;
  if (walls.axis != 0) velocity[0] = walls.speed[static_cast<std::size_t>(side)];
  if (walls.oscillates(side)) {
    velocity[walls.axis] = walls.oscillation->at(moving_walls_->phase(now_)).speed;
  }
  return velocity;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                              \
  template NextMeetings<Real> Simulation<Dim, Real>::with_walls(std::int32_t);         \
  template void Simulation<Dim, Real>::bounce(Collision<Dim, Real>&, int);             \
  template Real Simulation<Dim, Real>::wall_gap(std::int32_t, int, const Real&) const; \
  template Real Simulation<Dim, Real>::widest_wall_gap(std::int32_t, int, const Real&, \
                                                       const Real&) const;             \
  template Vec<Dim, Real> Simulation<Dim, Real>::wall_velocity(int) const;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
