#include "flow/measurements.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "flow/streaks.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim, class Real>
Measurements<Dim, Real>::Measurements(const Simulation<Dim, Real>& simulation,
                                      AverageStart after_time, double interval)
    : shear_rate_(simulation.box().shear_rate()),
      acceleration_(simulation.surroundings().acceleration),
      falls_(!(acceleration_ == Vector{})),
      are_unlike_(!simulation.grains().are_alike() || !simulation.spins().empty()),
      mobile_of_kind_(static_cast<std::size_t>(simulation.grains().kind_count())),
      clock_unit_(simulation.box().clock_unit()),
      is_start_found_(after_time.is_found()),
      after_time_(is_start_found_ ? std::numeric_limits<double>::infinity() : after_time.time()),
      after_{0, Real(after_time_)},
      initial_energy_(kinetic_energy(simulation)),
      flight_start_(static_cast<std::size_t>(simulation.spheres()), simulation.now()),
      next_look_(simulation.now()) {
  const auto& grains = simulation.grains();
  for (std::int32_t i = 0; i < simulation.spheres(); ++i) {
    mobile_of_kind_[static_cast<std::size_t>(grains.kind(i))] += !grains.is_immobile(i);
  }
  mobile_ = std::accumulate(mobile_of_kind_.begin(), mobile_of_kind_.end(), std::int64_t{0});
  if (mobile_of_kind_.size() > 1) sums_.kinetic_of_kind.resize(mobile_of_kind_.size());
  if (!simulation.spins().empty()) sums_.turning_of_kind.resize(mobile_of_kind_.size());
  if (after_time_ <= 0) sums_before_ = sums_;
  sums_at_end_ = sums_;
  Observables shape = observables(sums_, sums_, Real(1), simulation);
  if (simulation.box().is_sheared()) shape.streak_modes.resize(count_of_streak_modes<Dim>());
  if (grains.are_alike() && !simulation.box().closed_axis() && mobile_ > 1) shape.sonine_a2 = 0;
  series_ = ObservableSeries(shape, interval, simulation.spheres());
}

template <int Dim, class Real>
void Measurements<Dim, Real>::observe(const Collision<Dim, Real>& collision,
                                      const Simulation<Dim, Real>& simulation) {
  if (elapsed(next_look_, simulation.now(), clock_unit_) >= 0) look(simulation, &collision);
  const auto wall = simulation.wall(collision.j);
  if (!are_unlike_ && !wall) return observe_pair(collision, simulation);
  end_flight(collision.i, collision, simulation);
  if (wall) return add_wall_contact(collision, *wall, simulation);
  end_flight(collision.j, collision, simulation);
  add_transfer(collision.impact, collision.change * Real(-1));
  add_unlike_loss(collision, simulation);
}

/// The same of two unit spheres, all at once: nearly every collision is one of them.
template <int Dim, class Real>
[[gnu::flatten]] void Measurements<Dim, Real>::observe_pair(
    const Collision<Dim, Real>& collision, const Simulation<Dim, Real>& simulation) {
  auto& start_i = flight_start_[static_cast<std::size_t>(collision.i)];
  auto& start_j = flight_start_[static_cast<std::size_t>(collision.j)];
  const Real duration_i = elapsed(start_i, collision.time, clock_unit_);
  const Real duration_j = elapsed(start_j, collision.time, clock_unit_);
  start_i = start_j = collision.time;
  const Vector velocity_i = simulation.peculiar_velocity(collision.i) - collision.change;
  const Vector velocity_j = simulation.peculiar_velocity(collision.j) + collision.change;
  add(sums_, std::array{flight(velocity_i, duration_i, duration_i),
                        flight(velocity_j, duration_j, duration_j)});
  add_contact(collision);
}

/// Ends the flight of a sphere in a collision; its next one begins.
template <int Dim, class Real>
void Measurements<Dim, Real>::end_flight(std::int32_t sphere, const Collision<Dim, Real>& collision,
                                         const Simulation<Dim, Real>& simulation) {
  auto& start = flight_start_[static_cast<std::size_t>(sphere)];
  const Real duration = elapsed(start, collision.time, clock_unit_);
  start = collision.time;
  const Vector velocity = velocity_before(sphere, collision, simulation);
  if (!are_unlike_) return add(sums_, std::array{flight(velocity, duration, duration)});
  add_unlike_flight(sums_, sphere, velocity, spin_before(sphere, &collision, simulation), duration,
                    simulation);
}

/// Does what is due now: starts the averages, ends intervals.
///
/// \param collision  the one just done, whose flights are not added yet; or null
template <int Dim, class Real>
void Measurements<Dim, Real>::look(const Simulation<Dim, Real>& simulation,
                                   const Collision<Dim, Real>* collision) {
  start_averages(simulation, collision);
  if (!series_.has_interval()) choose_interval(simulation);
  if (!series_.has_interval()) return;
  end_intervals(series_, sums_at_end_, simulation, collision);
  const double next = sums_before_ ? series_.next_end() : std::min(series_.next_end(), after_time_);
  next_look_ = instant_at(next, clock_unit_, simulation.stride());
}

/// Appends the intervals that have ended by now.
///
/// \param sums_at_end  of the last one that is there; then likewise
template <int Dim, class Real>
void Measurements<Dim, Real>::end_intervals(ObservableSeries& series, Sums& sums_at_end,
                                            const Simulation<Dim, Real>& simulation,
                                            const Collision<Dim, Real>* collision) const {
  if (!simulation.has_reached(series.next_end())) return;
  const bool is_sheared = simulation.box().is_sheared();
  const auto streaks = is_sheared ? streak_amplitudes(simulation) : std::vector<double>{};
  while (simulation.has_reached(series.next_end())) {
    Sums sums = sums_;
    const auto end = instant_at(series.next_end(), clock_unit_, simulation.stride());
    add_flights_until(sums, end, simulation, collision);
    auto averages = observables(sums_at_end, sums, Real(series.interval()), simulation);
    averages.streak_modes = streaks;  // as they are now, a moment later
    if (series.shape().sonine_a2) averages.sonine_a2 = sonine_a2_at(end, simulation, collision);
    series.add(averages, simulation.collisions() - (collision ? 1 : 0));
    sums_at_end = sums;
  }
}

/// Notes the sums at `after_time`, once it has been reached.
template <int Dim, class Real>
void Measurements<Dim, Real>::start_averages(const Simulation<Dim, Real>& simulation,
                                             const Collision<Dim, Real>* collision) {
  if (sums_before_ || elapsed(after_, simulation.now(), clock_unit_) < 0) return;
  Sums sums = sums_;
  add_flights_until(sums, after_, simulation, collision);
  sums_before_ = sums;
}

/// Smooth spheres hand over momentum along the normal, those of a contact model also across it.
template <int Dim, class Real>
void Measurements<Dim, Real>::add_contact(const Collision<Dim, Real>& collision) {
  const auto& impact = collision.impact;
  add_transfer(impact, collision.change * Real(-1));
  sums_.dissipation += impact.impulse * (impact.normal_speed - impact.impulse);
}

template <int Dim, class Real>
void Measurements<Dim, Real>::add_wall_contact(const Collision<Dim, Real>& collision, int wall,
                                               const Simulation<Dim, Real>& simulation) {
  const auto& impact = collision.impact;
  add_transfer(impact, impact.normal * impact.impulse);
  const auto side = static_cast<std::size_t>(wall);
  const Vector after = simulation.peculiar_velocity(collision.i);
  const Real half_inverse =
      are_unlike_ ? Real(simulation.grains().inverse_mass(collision.i) / 2) : Real(0.5);
  Real gain = dot(collision.change, after - collision.change * half_inverse);
  if (!simulation.spins().empty()) {
    const auto spin = simulation.spins()[static_cast<std::size_t>(collision.i)];
    gain += (twice_turning_energy(collision.i, spin, simulation) -
             twice_turning_energy(collision.i, spin_before(collision.i, &collision, simulation),
                                  simulation)) /
            2;
  }
  // What a thermal wall gives is heat, and an oscillating one keeps up a sphere that rests on it.
  const bool only_gives = collision.resting || simulation.surroundings().walls->is_thermal(wall);
  const Real work = only_gives ? gain : dot(collision.change, simulation.wall_velocity(wall));
  sums_.wall_impulse[side] += impact.impulse;
  sums_.work_of_wall[side] += work;
  sums_.wall_work += work;
  sums_.dissipation += work - gain;
}

/// Adds what every contact hands over, from the first centre to the second.
template <int Dim, class Real>
void Measurements<Dim, Real>::add_transfer(const Impact<Dim, Real>& impact,
                                           const Vector& momentum) {
  const Vector arm = impact.normal * impact.distance;
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) {
      sums_.collisional[static_cast<std::size_t>(a * Dim + b)] += arm[a] * momentum[b];
    }
  }
  sums_.normal_speed += impact.normal_speed;
  ++sums_.collisions;
}

/// A flight that ends with the given peculiar velocity.
template <int Dim, class Real>
typename Measurements<Dim, Real>::Flight Measurements<Dim, Real>::flight(
    const Vector& velocity_at_end, const Real& duration, const Real& weight) const {
  Flight flight;
  if (falls_) flight.change = acceleration_ * duration;
  if constexpr (Dim > 1) {
    // v_y itself may change: over the flight its mean counts.
    flight.change[0] -= shear_rate_ * (velocity_at_end[1] - flight.change[1] / 2) * duration;
  }
  flight.mean = velocity_at_end - flight.change * Real(0.5);
  flight.weight = weight;
  return flight;
}

/// Adds the integrals over flights, in their order.
template <int Dim, class Real>
template <std::size_t Count>
void Measurements<Dim, Real>::add(Sums& sums, const std::array<Flight, Count>& flights) const {
  for (int a = 0; a < Dim; ++a) {
    for (int b = a; b < Dim; ++b) {
      Real sum = sums.kinetic[static_cast<std::size_t>(a * Dim + b)];
      for (const auto& [mean, change, weight] : flights) {
        Real square = mean[a] * mean[b];
        if (falls_ || b == 0) square += change[a] * change[b] / 12;  // else only along x
        sum += square * weight;
      }
      sums.kinetic[static_cast<std::size_t>(a * Dim + b)] = sum;
      sums.kinetic[static_cast<std::size_t>(b * Dim + a)] = sum;
    }
  }
  if (!falls_) return;
  for (const Flight& flight : flights) {
    sums.gravity_work += dot(acceleration_, flight.mean) * flight.weight;
  }
}

/// The same of a sphere with a mass, a kind or a spin of its own; an immobile one adds nothing.
///
/// \param spin  constant during the flight
template <int Dim, class Real>
void Measurements<Dim, Real>::add_unlike_flight(Sums& sums, std::int32_t sphere,
                                                const Vector& velocity_at_end,
                                                const Spin<Dim, Real>& spin, const Real& duration,
                                                const Simulation<Dim, Real>& simulation) const {
  const auto& grains = simulation.grains();
  if (grains.is_immobile(sphere)) return;
  const auto trace = [&] {
    Real sum = 0;
    for (std::size_t axis = 0; axis < Dim; ++axis) sum += sums.kinetic[axis * (Dim + 1)];
    return sum;
  };
  const auto kind = static_cast<std::size_t>(grains.kind(sphere));
  const Real before = trace();
  add(sums, std::array{flight(velocity_at_end, duration, duration * grains.mass(sphere))});
  if (!sums.kinetic_of_kind.empty()) sums.kinetic_of_kind[kind] += trace() - before;
  if (sums.turning_of_kind.empty()) return;
  sums.turning_of_kind[kind] += twice_turning_energy(sphere, spin, simulation) * duration;
}

/// Adds the part of every flight under way that lies before `end`.
///
/// \param collision  the one just done, whose spheres have new velocities; or null
template <int Dim, class Real>
void Measurements<Dim, Real>::add_flights_until(Sums& sums, const Instant<Real>& end,
                                                const Simulation<Dim, Real>& simulation,
                                                const Collision<Dim, Real>* collision) const {
  const Real ahead = elapsed(end, simulation.now(), clock_unit_);
  for (std::int32_t i = 0; i < simulation.spheres(); ++i) {
    const Vector velocity = velocity_at(ahead, i, collision, simulation);
    const Real duration = elapsed(flight_start_[static_cast<std::size_t>(i)], end, clock_unit_);
    if (!are_unlike_) {
      add(sums, std::array{flight(velocity, duration, duration)});
    } else {
      const bool has_collided = collision && (i == collision->i || i == collision->j);
      add_unlike_flight(sums, i, velocity,
                        spin_before(i, has_collided ? collision : nullptr, simulation), duration,
                        simulation);
    }
  }
}

/// Peculiar velocity on the flight that was under way a time `ahead` ago.
///
/// \param collision  the one just done, whose spheres have new velocities; or null
template <int Dim, class Real>
Vec<Dim, Real> Measurements<Dim, Real>::velocity_at(const Real& ahead, std::int32_t sphere,
                                                    const Collision<Dim, Real>* collision,
                                                    const Simulation<Dim, Real>& simulation) const {
  const bool has_collided = collision && (sphere == collision->i || sphere == collision->j);
  Vector velocity = has_collided ? velocity_before(sphere, *collision, simulation)
                                 : simulation.peculiar_velocity(sphere);
  if constexpr (Dim > 1) velocity[0] += shear_rate_ * velocity[1] * ahead;
  velocity -= acceleration_ * ahead;
  return velocity;
}

template <int Dim, class Real>
Vec<Dim, Real> Measurements<Dim, Real>::velocity_before(
    std::int32_t sphere, const Collision<Dim, Real>& collision,
    const Simulation<Dim, Real>& simulation) const {
  const Vector after = simulation.peculiar_velocity(sphere);
  if (are_unlike_) {
    const Vector change = collision.change * simulation.grains().inverse_mass(sphere);
    return sphere == collision.i ? after - change : after + change;
  }
  return sphere == collision.i ? after - collision.change : after + collision.change;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class Measurements<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
