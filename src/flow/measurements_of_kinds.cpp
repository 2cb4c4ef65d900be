// Measurements of spheres that have masses of their own, are of several kinds, or turn.

#include "flow/measurements.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

/// Adds what a collision of spheres with masses of their own takes, friction included. One that is
/// immobile does work on the other, as a wall that moves.
template <int Dim, class Real>
void Measurements<Dim, Real>::add_unlike_loss(const Collision<Dim, Real>& collision,
                                              const Simulation<Dim, Real>& simulation) {
  const auto& impact = collision.impact;
  const auto& grains = simulation.grains();
  const Real inverse_masses = grains.inverse_mass(collision.i) + grains.inverse_mass(collision.j);
  sums_.dissipation +=
      impact.impulse * (impact.normal_speed - impact.impulse * inverse_masses / 2) +
      collision.friction_loss;
  if (grains.is_immobile(collision.i)) {
    sums_.wall_work -= dot(collision.change, simulation.peculiar_velocity(collision.i));
  } else if (grains.is_immobile(collision.j)) {
    sums_.wall_work += dot(collision.change, simulation.peculiar_velocity(collision.j));
  }
}

/// The spin of a sphere, before a collision that it has just had; zero where nothing turns.
template <int Dim, class Real>
Spin<Dim, Real> Measurements<Dim, Real>::spin_before(
    std::int32_t sphere, const Collision<Dim, Real>* collision,
    const Simulation<Dim, Real>& simulation) const {
  if (simulation.spins().empty()) return {};
  Spin<Dim, Real> spin = simulation.spins()[static_cast<std::size_t>(sphere)];
  if (collision) spin -= simulation.change_of_spin(*collision, sphere);
  return spin;
}

template <int Dim, class Real>
Real Measurements<Dim, Real>::twice_turning_energy(std::int32_t sphere, const Spin<Dim, Real>& spin,
                                                   const Simulation<Dim, Real>& simulation) const {
  if (simulation.spins().empty()) return 0;
  return dot(spin, spin) * simulation.moment_of_inertia(sphere);
}

/// The temperatures of the spins and of each kind, where there are such.
template <int Dim, class Real>
void Measurements<Dim, Real>::add_temperatures(Observables& averages, const Sums& sums,
                                               const Sums& before, const Real& span) const {
  const auto of_kinds = [&](const std::vector<Real>& now, const std::vector<Real>& then, int axes) {
    std::vector<double> temperatures;
    for (std::size_t kind = 0; kind < now.size(); ++kind) {
      const Real mobile = static_cast<Real>(mobile_of_kind_[kind]) * axes;
      temperatures.push_back(static_cast<double>((now[kind] - then[kind]) / (mobile * span)));
    }
    return temperatures;
  };
  averages.temperature_of_kind = of_kinds(sums.kinetic_of_kind, before.kinetic_of_kind, Dim);
  if (sums.turning_of_kind.empty()) return;
  const auto turning = of_kinds(sums.turning_of_kind, before.turning_of_kind, spin_axes<Dim>);
  double sum = 0;
  for (std::size_t kind = 0; kind < turning.size(); ++kind) {
    if (mobile_of_kind_[kind] > 0)
      sum += turning[kind] * static_cast<double>(mobile_of_kind_[kind]);
  }
  averages.rotational_temperature = sum / static_cast<double>(mobile_);
  if (turning.size() > 1) averages.rotational_temperature_of_kind = turning;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                                         \
  template void Measurements<Dim, Real>::add_unlike_loss(const Collision<Dim, Real>&,             \
                                                         const Simulation<Dim, Real>&);           \
  template Spin<Dim, Real> Measurements<Dim, Real>::spin_before(                                  \
      std::int32_t, const Collision<Dim, Real>*, const Simulation<Dim, Real>&) const;             \
  template Real Measurements<Dim, Real>::twice_turning_energy(                                    \
      std::int32_t, const Spin<Dim, Real>&, const Simulation<Dim, Real>&) const;                  \
  template void Measurements<Dim, Real>::add_temperatures(Observables&, const Sums&, const Sums&, \
                                                          const Real&) const;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
