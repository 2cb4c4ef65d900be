#include "flow/measurements.hpp"

#include <algorithm>
#include <cmath>

#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim, class Real>
Measurements<Dim, Real>::Measurements(const Simulation<Dim, Real>& simulation, double after_time)
    : shear_rate_(simulation.box().shear_rate()),
      clock_unit_(simulation.box().clock_unit()),
      after_time_(after_time),
      after_{0, Real(after_time)},
      initial_energy_(kinetic_energy(simulation)),
      flight_start_(static_cast<std::size_t>(simulation.spheres()), simulation.now()) {
  if (after_time <= 0) sums_before_ = Sums{};
}

template <int Dim, class Real>
void Measurements<Dim, Real>::observe(const Collision<Dim, Real>& collision,
                                      const Simulation<Dim, Real>& simulation) {
  if (!sums_before_ && elapsed(after_, collision.time, clock_unit_) >= 0) {
    sums_before_ = sums_;
    add_flights_until(*sums_before_, after_, simulation, &collision);
  }
  for (const std::int32_t sphere : {collision.i, collision.j}) {
    auto& start = flight_start_[static_cast<std::size_t>(sphere)];
    add_flight(sums_, velocity_before(sphere, collision, simulation),
               elapsed(start, collision.time, clock_unit_));
    start = collision.time;
  }
  const auto& impact = collision.impact;
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) {
      sums_.collisional[static_cast<std::size_t>(a * Dim + b)] +=
          impact.distance * impact.impulse * impact.normal[a] * impact.normal[b];
    }
  }
  sums_.dissipation += impact.impulse * (impact.normal_speed - impact.impulse);
  sums_.normal_speed += impact.normal_speed;
  ++sums_.collisions;
}

/// Adds the integral of v_a v_b over a flight that ends with the given peculiar velocity.
template <int Dim, class Real>
void Measurements<Dim, Real>::add_flight(Sums& sums, const Vector& velocity_at_end,
                                         const Real& duration) const {
  Vector mean = velocity_at_end;
  Real change = 0;  // of v_x over the flight
  if constexpr (Dim > 1) {
    change = -shear_rate_ * velocity_at_end[1] * duration;
    mean[0] -= change / 2;
  }
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) {
      sums.kinetic[static_cast<std::size_t>(a * Dim + b)] += mean[a] * mean[b] * duration;
    }
  }
  sums.kinetic[0] += change * change / 12 * duration;
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
    const bool has_collided = collision && (i == collision->i || i == collision->j);
    Vector velocity =
        has_collided ? velocity_before(i, *collision, simulation) : simulation.peculiar_velocity(i);
    if constexpr (Dim > 1) velocity[0] += shear_rate_ * velocity[1] * ahead;
    add_flight(sums, velocity,
               elapsed(flight_start_[static_cast<std::size_t>(i)], end, clock_unit_));
  }
}

template <int Dim, class Real>
Vec<Dim, Real> Measurements<Dim, Real>::velocity_before(
    std::int32_t sphere, const Collision<Dim, Real>& collision,
    const Simulation<Dim, Real>& simulation) const {
  const Vector change = collision.impact.normal * collision.impact.impulse;
  const Vector after = simulation.peculiar_velocity(sphere);
  return sphere == collision.i ? after + change : after - change;
}

template <int Dim, class Real>
typename Measurements<Dim, Real>::Sums Measurements<Dim, Real>::sums_now(
    const Simulation<Dim, Real>& simulation) const {
  Sums sums = sums_;
  add_flights_until(sums, simulation.now(), simulation, nullptr);
  return sums;
}

template <int Dim, class Real>
Real Measurements<Dim, Real>::kinetic_energy(const Simulation<Dim, Real>& simulation) const {
  Real twice = 0;
  for (std::int32_t i = 0; i < simulation.spheres(); ++i) {
    const Vector velocity = simulation.peculiar_velocity(i);
    twice += dot(velocity, velocity);
  }
  return twice / 2;
}

template <int Dim, class Real>
double Measurements<Dim, Real>::ledger_error(const Simulation<Dim, Real>& simulation) const {
  using std::abs;
  const Sums sums = sums_now(simulation);
  const Real energy = kinetic_energy(simulation);
  Real work = 0;
  if constexpr (Dim > 1) work = -shear_rate_ * (sums.kinetic[1] + sums.collisional[1]);
  const Real error = abs(energy - initial_energy_ - work + sums.dissipation);
  const Real scale = std::max({energy, initial_energy_, Real(abs(work)), sums.dissipation});
  return scale > 0 ? static_cast<double>(error / scale) : 0;
}

template <int Dim, class Real>
std::optional<Averages> Measurements<Dim, Real>::averages(
    const Simulation<Dim, Real>& simulation) const {
  const Real span = elapsed(after_, simulation.now(), clock_unit_);
  if (!(span > 0)) return std::nullopt;
  const Sums sums = sums_now(simulation);
  Sums before;
  if (sums_before_) {
    before = *sums_before_;
  } else {  // no collision since
    before = sums_;
    add_flights_until(before, after_, simulation, nullptr);
  }
  const Real spheres = static_cast<Real>(simulation.spheres());
  const Real volume = simulation.box().volume();
  Averages averages;
  Real trace_v = 0;
  Real trace_p = 0;
  for (std::size_t ab = 0; ab < Dim * Dim; ++ab) {
    const Real kinetic = sums.kinetic[ab] - before.kinetic[ab];
    const Real pressure =
        (kinetic + (sums.collisional[ab] - before.collisional[ab])) / (volume * span);
    averages.pressure_tensor.push_back(static_cast<double>(pressure));
    if (ab % (Dim + 1) != 0) continue;
    averages.temperature_diagonal.push_back(static_cast<double>(kinetic / (spheres * span)));
    trace_v += kinetic / (spheres * span);
    trace_p += pressure;
  }
  const Real collisions = static_cast<Real>(sums.collisions - before.collisions);
  const Real temperature = trace_v / Dim;
  averages.granular_temperature = static_cast<double>(temperature);
  averages.pressure = static_cast<double>(trace_p / Dim);
  averages.collision_rate = static_cast<double>(2 * collisions / (spheres * span));
  averages.dissipation =
      static_cast<double>((sums.dissipation - before.dissipation) / (volume * span));
  if constexpr (Dim > 1) {
    averages.shear_work = -averages.pressure_tensor[1] * static_cast<double>(shear_rate_);
  }
  averages.compressibility_factor =
      static_cast<double>(trace_p / Dim * volume / (spheres * temperature));
  averages.normal_speed =
      static_cast<double>((sums.normal_speed - before.normal_speed) / collisions);
  averages.from_time = after_time_;
  averages.to_time = simulation.time();
  return averages;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class Measurements<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
