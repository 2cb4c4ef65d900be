// What the contact of a sphere and a wall does.

#include <algorithm>
#include <cmath>

#include "engine/simulation.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

/// The collision of a sphere with a wall.
template <int Dim, class Real>
void Simulation<Dim, Real>::bounce(Collision<Dim, Real>& collision, int wall) {
  const Walls<Real>& walls = *system_.surroundings.walls;
  auto& sphere = system_.spheres[collision.i];
  Real least = 0;
  if (walls.oscillates(wall)) {
    least = touch_oscillating_wall(collision.i);
  } else {
    touch_wall(collision.i, wall);
  }
  const Vector before = sphere.velocity;
  Vector velocity =
      system_.frame.moves() ? sphere.velocity + system_.frame.velocity(now()) : sphere.velocity;
  ++sphere.collisions;
  if (walls.oscillates(wall))
    velocity[walls.axis] = system_.moving_walls->departure(collision.i).speed;
  bool turns = false;
  if (walls.is_thermal(wall)) {
    const Real mass = grains().mass(collision.i);
    const Vector after = system_.moving_walls->thermal_velocity(walls, wall, mass);
    const auto bounce =
        thermal_impact(walls, wall, velocity, after, mass, system_.radius(collision.i));
    collision.impact = bounce.impact;
    collision.change = bounce.change;
    sphere.velocity = system_.frame.moves() ? after - system_.frame.velocity(now()) : after;
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
  const Walls<Real>& walls = *system_.surroundings.walls;
  auto& sphere = system_.spheres[i];
  const Real outward = wall == 0 ? -1 : 1;
  const Real acceleration = -outward * system_.surroundings.acceleration[walls.axis];
  Real& velocity = sphere.velocity[walls.axis];
  const Real speed = closing_speed<Real>(system_.wall_gap(i, wall, sphere.time),
                                         -outward * velocity, acceleration);
  system_.spheres.advance(i, clock().remainder());
  const Real radius = system_.radius(i);
  sphere.position[walls.axis] = wall == 0 ? radius : Real(box().sides()[walls.axis] - radius);
  if (acceleration != 0) velocity = outward * speed;
}

/// The same at the wall that oscillates. Its departure becomes the arrival, with the speed relative
/// to the wall.
///
/// \return  the speed with which it has to be let go at least if the wall holds it
template <int Dim, class Real>
Real Simulation<Dim, Real>::touch_oscillating_wall(std::int32_t i) {
  const Walls<Real>& walls = *system_.surroundings.walls;
  auto& sphere = system_.spheres[i];
  const auto [gap, from] = system_.oscillating_gap(i);
  const auto arrival = gap.at(clock().remainder() - from);
  const Real rate = -closing_speed(arrival.gap, arrival.rate, arrival.acceleration);
  const auto state = walls.oscillation->at(system_.moving_walls->phase(now()));
  system_.spheres.advance(i, clock().remainder());
  sphere.position[walls.axis] = system_.radius(i) + state.height;
  sphere.velocity[walls.axis] = state.speed + rate;
  system_.moving_walls->departure(i) = {now(), rate, sphere.collisions};
  const Real pull = state.acceleration - system_.surroundings.acceleration[walls.axis];
  return pull > 0 ? Real(pull * walls.resting_flight / 2) : Real(0);
}

/// Notes how a sphere leaves the wall that oscillates.
///
/// \param least  with which it is let go at least
template <int Dim, class Real>
void Simulation<Dim, Real>::depart(const Collision<Dim, Real>& collision, const Real& least) {
  auto& departure = system_.moving_walls->departure(collision.i);
  const Real mass = grains().mass(collision.i);
  const Real speed = collision.impact.impulse / mass - collision.impact.normal_speed;
  departure.speed = collision.resting ? least : speed;
  departure.collisions = system_.spheres[collision.i].collisions;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) \
  template void Simulation<Dim, Real>::bounce(Collision<Dim, Real>&, int);
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
