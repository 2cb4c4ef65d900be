#pragma once

#include "support/gas.hpp"

namespace zenosphere::support {

/// Kinds of spheres in a test.
struct Kind {
  int spheres;
  double diameter;
  double mass;
};

/// What so many spheres of each kind are.
inline Grains<double> grains_of(const std::vector<Kind>& kinds) {
  Grains<double> grains;
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    for (int n = 0; n < kinds[kind].spheres; ++n) {
      grains.diameters.push_back(kinds[kind].diameter);
      grains.masses.push_back(kinds[kind].mass);
      grains.kinds.push_back(static_cast<std::int32_t>(kind));
    }
  }
  return grains;
}

/// As random_gas(), of several kinds: the first finds room first, so it should be the largest. All
/// have the same temperature at first, up to chance, and the momentum is zero.
///
/// \param speed  each component of the velocity of a unit mass lies in (-speed, speed)
inline State random_mixture(const std::vector<Kind>& kinds, const Vector& sides, double speed,
                            std::uint64_t seed) {
  Dice dice(seed);
  State state;
  state.grains = grains_of(kinds);
  const auto spheres = static_cast<std::int32_t>(state.grains.diameters.size());
  for (int trial = 0; static_cast<std::int32_t>(state.positions.size()) < spheres; ++trial) {
    if (trial > 10000000) throw std::runtime_error("no room for another sphere");
    const auto i = static_cast<std::int32_t>(state.positions.size());
    Vector place;
    for (int axis = 0; axis < 3; ++axis) place[axis] = dice.between(0, sides[axis]);
    bool is_free = true;
    for (std::int32_t j = 0; j < i; ++j) {
      const double sigma = state.grains.radius(i) + state.grains.radius(j);
      const Vector& other = state.positions[static_cast<std::size_t>(j)];
      if (nearest_distance(place, other, sides) < sigma) is_free = false;
    }
    if (is_free) state.positions.push_back(place);
  }
  Vector momentum;
  double mass = 0;
  for (std::int32_t i = 0; i < spheres; ++i) {
    Vector velocity;
    for (int axis = 0; axis < 3; ++axis) velocity[axis] = dice.between(-speed, speed);
    velocity *= 1 / std::sqrt(state.grains.mass(i));
    state.velocities.push_back(velocity);
    momentum += velocity * state.grains.mass(i);
    mass += state.grains.mass(i);
  }
  for (Vector& velocity : state.velocities) velocity -= momentum * (1 / mass);
  return state;
}

/// Random spins, each component in (-most, most).
inline void add_spins(State& state, double most, std::uint64_t seed) {
  Dice dice(seed);
  for (std::size_t i = 0; i < state.positions.size(); ++i) {
    auto& spin = state.spins.emplace_back();
    for (int axis = 0; axis < 3; ++axis) spin[axis] = dice.between(-most, most);
  }
}

/// Rules with the same constants for all pairs.
inline ContactRules<double> rough(const ContactConstants<double>& constants,
                                  std::int32_t kinds = 1) {
  ContactRules<double> rules{constants.restitution};
  rules.table.emplace(kinds, constants);
  return rules;
}

/// Kinetic energy of the peculiar motion and of the spins.
inline double energy(const Gas& gas) {
  double twice = 0;
  for (std::int32_t i = 0; i < gas.spheres(); ++i) {
    if (gas.grains().is_immobile(i)) continue;
    const Vector velocity = gas.peculiar_velocity(i);
    twice += gas.grains().mass(i) * dot(velocity, velocity);
    if (gas.spins().empty()) continue;
    const auto& spin = gas.spins()[static_cast<std::size_t>(i)];
    twice += gas.moment_of_inertia(i) * dot(spin, spin);
  }
  return twice / 2;
}

}  // namespace zenosphere::support
