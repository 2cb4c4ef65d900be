// What a run's measurements come to: averages, their series, and the ledger.

#include <algorithm>
#include <cmath>

#include "flow/measurements.hpp"
#include "flow/reliability.hpp"
#include "flow/sonine.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {
namespace {

/// Of the mobile spheres.
template <class Real>
Real total_mass(const Grains<Real>& grains, std::int32_t spheres) {
  if (grains.are_alike()) return Real(spheres);
  Real sum = 0;
  for (std::int32_t i = 0; i < spheres; ++i) {
    if (!grains.is_immobile(i)) sum += grains.mass(i);
  }
  return sum;
}

/// (P_xx - P_yy)/p and, in three dimensions, (P_yy - P_zz)/p.
///
/// Source: Alam & Luding, Phys. Fluids 15 (2003) 2298.
template <int Dim>
std::vector<double> normal_stress_differences(const Observables& averages) {
  std::vector<double> differences;
  for (std::size_t a = 0; a + 1 < Dim; ++a) {
    const double along = averages.pressure_tensor[a * (Dim + 1)];
    const double next = averages.pressure_tensor[(a + 1) * (Dim + 1)];
    differences.push_back((along - next) / averages.pressure);
  }
  return differences;
}

}  // namespace

template <int Dim, class Real>
Real Measurements<Dim, Real>::shear_work(const Sums& sums) const {
  if constexpr (Dim == 1) return 0;
  // Momentum along x handed over along y: row y of the tensor, which rotated contacts make uneven.
  const std::size_t yx = Dim > 1 ? Dim : 0;
  return -shear_rate_ * (sums.kinetic[yx] + sums.collisional[yx]);
}

template <int Dim, class Real>
Real Measurements<Dim, Real>::kinetic_energy(const Simulation<Dim, Real>& simulation) const {
  Real twice = 0;
  for (std::int32_t i = 0; i < simulation.spheres(); ++i) {
    const Vector velocity = simulation.peculiar_velocity(i);
    if (!are_unlike_) {
      twice += dot(velocity, velocity);
    } else if (!simulation.grains().is_immobile(i)) {
      twice += dot(velocity, velocity) * simulation.grains().mass(i) +
               twice_turning_energy(i, spin_before(i, nullptr, simulation), simulation);
    }
  }
  return twice / 2;
}

template <int Dim, class Real>
double Measurements<Dim, Real>::ledger_error(const Simulation<Dim, Real>& simulation) const {
  using std::abs;
  const Sums sums = sums_now(simulation);
  const Real energy = kinetic_energy(simulation);
  const Real work = shear_work(sums) + sums.gravity_work + sums.wall_work + sums.kick_work;
  const Real error = abs(energy - initial_energy_ - work + sums.dissipation);
  // A ball that bounces low has little energy, but places are rounded as parts of the whole box.
  Real potential = 0;
  if (const auto axis = simulation.box().closed_axis()) {
    potential = total_mass(simulation.grains(), simulation.spheres()) *
                Real(abs(acceleration_[*axis])) * simulation.box().sides()[*axis];
  }
  const Real scale = std::max({potential, energy, initial_energy_, Real(abs(shear_work(sums))),
                               Real(abs(sums.gravity_work)), Real(abs(sums.wall_work)),
                               sums.kick_work, sums.dissipation});
  return scale > 0 ? static_cast<double>(error / scale) : 0;
}

template <int Dim, class Real>
std::optional<Averages> Measurements<Dim, Real>::averages(
    const Simulation<Dim, Real>& simulation) const {
  if (is_start_found_) return averages_of_steady_state(simulation);
  const Real span = elapsed(after_, simulation.now(), clock_unit_);
  if (!(span > 0)) return std::nullopt;
  Sums before;
  if (sums_before_) {
    before = *sums_before_;
  } else {  // no collision since
    before = sums_;
    add_flights_until(before, after_, simulation, nullptr);
  }
  Averages averages{observables(before, sums_now(simulation), span, simulation)};
  averages.streak_modes.resize(series_.shape().streak_modes.size());
  averages.from_time = after_time_;
  averages.to_time = simulation.time();
  add_reliability(averages, series(simulation), inertia(simulation));
  return averages;
}

template <int Dim, class Real>
ObservableSeries Measurements<Dim, Real>::series(const Simulation<Dim, Real>& simulation) const {
  ObservableSeries series = series_;
  Sums sums = sums_at_end_;
  if (series.has_interval()) end_intervals(series, sums, simulation, nullptr);
  return series;
}

/// Averages from the first interval of the steady state on, up to now.
template <int Dim, class Real>
std::optional<Averages> Measurements<Dim, Real>::averages_of_steady_state(
    const Simulation<Dim, Real>& simulation) const {
  ObservableSeries series = series_;
  Sums sums = sums_at_end_;
  if (series.has_interval()) end_intervals(series, sums, simulation, nullptr);
  const Instant<Real> end = instant_at(series.end(), clock_unit_, simulation.stride());
  const Real rest = elapsed(end, simulation.now(), clock_unit_);
  if (series.rows() == 0 && !(rest > 0)) return std::nullopt;
  const std::size_t first = first_steady(series);
  Observables last = observables(sums, sums_now(simulation), rest, simulation);
  last.streak_modes.resize(series.shape().streak_modes.size());
  last.sonine_a2 = series.shape().sonine_a2;
  Averages averages{series.mean(first, last, static_cast<double>(rest))};
  averages.from_time = series.end_of(first);
  averages.to_time = simulation.time();
  add_reliability(averages, series, inertia(simulation));
  return averages;
}

/// Of all spheres, as they were at `end`.
///
/// \param collision  the one just done, after it; or null
template <int Dim, class Real>
double Measurements<Dim, Real>::sonine_a2_at(const Instant<Real>& end,
                                             const Simulation<Dim, Real>& simulation,
                                             const Collision<Dim, Real>* collision) const {
  const Real ahead = elapsed(end, simulation.now(), clock_unit_);
  std::vector<Vec<Dim, double>> velocities(static_cast<std::size_t>(simulation.spheres()));
  for (std::int32_t i = 0; i < simulation.spheres(); ++i) {
    const Vector velocity = velocity_at(ahead, i, collision, simulation);
    for (int axis = 0; axis < Dim; ++axis) {
      velocities[static_cast<std::size_t>(i)][axis] = static_cast<double>(velocity[axis]);
    }
  }
  return second_sonine_coefficient<Dim>(velocities);
}

/// Of the mobile spheres.
template <int Dim, class Real>
Inertia Measurements<Dim, Real>::inertia(const Simulation<Dim, Real>& simulation) const {
  const Real mass = total_mass(simulation.grains(), simulation.spheres());
  return {static_cast<double>(mobile_), static_cast<double>(mass) / static_cast<double>(mobile_)};
}

/// Averages over a time of which the sums at its begin and at its end are known.
template <int Dim, class Real>
Observables Measurements<Dim, Real>::observables(const Sums& before, const Sums& now,
                                                 const Real& span,
                                                 const Simulation<Dim, Real>& simulation) const {
  const auto& box = simulation.box();
  const Real spheres = static_cast<Real>(simulation.spheres());
  const Real mobile = static_cast<Real>(mobile_);
  const Real volume = box.volume();
  const auto rate = [&](const Real& later, const Real& earlier) {  // per volume and time
    return static_cast<double>((later - earlier) / (volume * span));
  };
  Observables averages;
  for (std::size_t ab = 0; ab < Dim * Dim; ++ab) {
    averages.pressure_tensor.push_back(
        rate(now.kinetic[ab] + now.collisional[ab], before.kinetic[ab] + before.collisional[ab]));
    if (ab % (Dim + 1) != 0) continue;
    const double temperature =
        static_cast<double>((now.kinetic[ab] - before.kinetic[ab]) / (mobile * span));
    averages.temperature_diagonal.push_back(temperature);
    averages.granular_temperature += temperature / Dim;
    averages.pressure += averages.pressure_tensor[ab] / Dim;
  }
  const Real collisions = static_cast<Real>(now.collisions - before.collisions);
  averages.collision_rate = static_cast<double>(2 * collisions / (spheres * span));
  averages.dissipation = rate(now.dissipation, before.dissipation);
  averages.shear_work = rate(shear_work(now), shear_work(before));
  averages.other_work = rate(now.gravity_work + now.wall_work + now.kick_work,
                             before.gravity_work + before.wall_work + before.kick_work);
  if (const auto axis = box.closed_axis()) {
    for (const std::size_t wall : {0, 1}) {
      averages.wall_pressure.push_back(static_cast<double>(box.sides()[*axis]) *
                                       rate(now.wall_impulse[wall], before.wall_impulse[wall]));
    }
    const auto& walls = *simulation.surroundings().walls;
    for (const std::size_t wall : {0, 1}) {
      if (!MovingWalls<Dim, Real>::are_needed(walls)) break;
      averages.wall_work.push_back(static_cast<double>(box.sides()[*axis]) *
                                   rate(now.work_of_wall[wall], before.work_of_wall[wall]));
    }
  }
  averages.compressibility_factor =
      averages.pressure * static_cast<double>(volume / mobile) / averages.granular_temperature;
  averages.normal_speed =
      static_cast<double>((now.normal_speed - before.normal_speed) / collisions);
  if (box.is_sheared())
    averages.normal_stress_differences = normal_stress_differences<Dim>(averages);
  add_temperatures(averages, now, before, span);
  return averages;
}

/// Sets the interval of the series, where it is known how often the spheres collide: so that it is
/// some collisions of each, and its ends are exact numbers.
template <int Dim, class Real>
void Measurements<Dim, Real>::choose_interval(const Simulation<Dim, Real>& simulation) {
  constexpr std::int64_t fewest = 256;
  const std::int64_t collisions = std::max(4 * std::int64_t{simulation.spheres()}, fewest);
  const double time = simulation.time();
  constexpr double most = 0x1p1000;  // twice as often as there can be intervals it has to fit
  if (simulation.collisions() < collisions || !(time > 0) || time > most) return;
  series_.set_interval(std::exp2(std::ceil(std::log2(time))));
}

template <int Dim, class Real>
void Measurements<Dim, Real>::kick(Simulation<Dim, Real>& simulation,
                                   const std::vector<Vector>& changes) {
  look(simulation, nullptr);
  sums_ = sums_now(simulation);
  std::fill(flight_start_.begin(), flight_start_.end(), simulation.now());
  const Real energy = kinetic_energy(simulation);
  simulation.kick(changes);
  sums_.kick_work += kinetic_energy(simulation) - energy;
}

template <int Dim, class Real>
typename Measurements<Dim, Real>::Sums Measurements<Dim, Real>::sums_now(
    const Simulation<Dim, Real>& simulation) const {
  Sums sums = sums_;
  add_flights_until(sums, simulation.now(), simulation, nullptr);
  return sums;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                                          \
  template double Measurements<Dim, Real>::ledger_error(const Simulation<Dim, Real>&) const;       \
  template std::optional<Averages> Measurements<Dim, Real>::averages(const Simulation<Dim, Real>&) \
      const;                                                                                       \
  template ObservableSeries Measurements<Dim, Real>::series(const Simulation<Dim, Real>&) const;   \
  template void Measurements<Dim, Real>::choose_interval(const Simulation<Dim, Real>&);            \
  template void Measurements<Dim, Real>::kick(Simulation<Dim, Real>&, const std::vector<Vector>&); \
  template typename Measurements<Dim, Real>::Sums Measurements<Dim, Real>::sums_now(               \
      const Simulation<Dim, Real>&) const;                                                         \
  template Real Measurements<Dim, Real>::kinetic_energy(const Simulation<Dim, Real>&) const;       \
  template double Measurements<Dim, Real>::sonine_a2_at(                                           \
      const Instant<Real>&, const Simulation<Dim, Real>&, const Collision<Dim, Real>*) const;      \
  template Observables Measurements<Dim, Real>::observables(const Sums&, const Sums&, const Real&, \
                                                            const Simulation<Dim, Real>&) const;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
