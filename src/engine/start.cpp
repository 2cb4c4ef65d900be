#include "engine/start.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/close_pairs.hpp"
#include "engine/growth.hpp"
#include "engine/loose_packing.hpp"
#include "engine/simulation.hpp"
#include "model/instantiate.hpp"
#include "model/power.hpp"
#include "model/shuffle.hpp"

namespace zenosphere {

namespace {

std::vector<Vec<3, double>> fcc_lattice(std::int32_t spheres, double side) {
  constexpr double basis[4][3] = {{0, 0, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}};
  int n = 0;
  while (4 * n * n * n < spheres) ++n;
  if (4 * n * n * n != spheres) throw std::invalid_argument("fcc needs 4 n^3 spheres");
  const double spacing = side / n;
  std::vector<Vec<3, double>> positions;
  positions.reserve(static_cast<std::size_t>(spheres));
  for (int z = 0; z < n; ++z) {
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        for (const auto& site : basis) {
          // A quarter of a spacing away from the faces of the box, so that no sphere is on one.
          positions.push_back({(x + site[0] + 0.25) * spacing, (y + site[1] + 0.25) * spacing,
                               (z + site[2] + 0.25) * spacing});
        }
      }
    }
  }
  return positions;
}

/// Whether random places of unit spheres are those of loose_packing().
///
/// Above 0.494 hard spheres begin to freeze, so that mixing no longer forgets the order of the
/// pushing (Hoover & Ree, J. Chem. Phys. 49 (1968) 3609); disks do above 0.70 (Bernard & Krauth,
/// Phys. Rev. Lett. 107 (2011) 155704), and mix slowly before; rods have no order to forget.
template <int Dim>
bool is_loose(std::int32_t spheres, const ShearBox<Dim, double>& box) {
  constexpr std::array densest{1.0, 0.6, 0.5};
  constexpr double rounding = 1e-9;  // of a box that was made to be filled to the densest
  return spheres * unit_sphere_volume(Dim) / box.volume() <= densest[Dim - 1] * (1 + rounding);
}

/// Overlaps pushed apart, then mixed by elastic collisions at unit temperature.
template <int Dim>
std::vector<Vec<Dim, double>> loose_places(std::int32_t spheres, const ShearBox<Dim, double>& box,
                                           Random& random) {
  // At 0.3 the pushing is forgotten after a few collisions per sphere; at 0.5 the pressure is 3 %
  // too high for the first time unit and settles within the next half.
  constexpr std::int64_t collisions_per_sphere = 20;
  constexpr double mixing_time = 1.5;
  Configuration<Dim, double> state;
  state.positions = loose_packing<Dim>(spheres, box, random);
  state.velocities = thermal_velocities<Dim>(spheres, 1.0, random);
  Surroundings<Dim, double> surroundings;
  if (const auto axis = box.closed_axis()) surroundings.walls = Walls<double>{.axis = *axis};
  const double width = fitting_cell_width({box.sides().components, spheres});
  const ShearBox<Dim, double> still(box.sides(), 0, width, box.closed_axis());
  Simulation<Dim, double> mixing(still, state, {1.0}, surroundings);
  const std::int64_t collisions = collisions_per_sphere * spheres / 2;
  // A gas too thin to collide is mixed already: a unit speed crosses the box in its side.
  double longest = 0;
  for (int axis = 0; axis < Dim; ++axis) longest = std::max(longest, 20 * box.sides()[axis]);
  const auto is_mixed = [&] {
    return mixing.collisions() >= collisions && mixing.has_reached(mixing_time);
  };
  while (!is_mixed() && !mixing.has_reached(longest)) {
    mixing.next_collision(longest);
  }
  return mixing.configuration().positions;
}

/// Velocities of spheres that are not all alike. (Those of unit spheres would get other last digits
/// here.)
template <int Dim>
std::vector<Vec<Dim, double>> velocities_by_mass(std::int32_t spheres, double temperature,
                                                 Random& random, const Grains<double>& grains) {
  std::vector<Vec<Dim, double>> velocities(static_cast<std::size_t>(spheres));
  Vec<Dim, double> momentum;
  double mobile_mass = 0;
  std::int32_t mobile = 0;
  for (std::int32_t i = 0; i < spheres; ++i) {
    if (grains.is_immobile(i)) continue;
    auto& velocity = velocities[static_cast<std::size_t>(i)];
    for (int axis = 0; axis < Dim; ++axis) {
      velocity[axis] = random.normal() / std::sqrt(grains.mass(i));
    }
    momentum += velocity * grains.mass(i);
    mobile_mass += grains.mass(i);
    ++mobile;
  }
  double twice_energy = 0;
  for (std::int32_t i = 0; i < spheres; ++i) {
    if (grains.is_immobile(i)) continue;
    auto& velocity = velocities[static_cast<std::size_t>(i)];
    if (mobile > 1) velocity -= momentum * (1 / mobile_mass);
    twice_energy += grains.mass(i) * dot(velocity, velocity);
  }
  const double scale = twice_energy > 0 ? std::sqrt(temperature * Dim * mobile / twice_energy) : 0;
  for (auto& velocity : velocities) velocity *= scale;
  return velocities;
}

}  // namespace

template <int Dim>
std::vector<Vec<Dim, double>> thermal_velocities(std::int32_t spheres, double temperature,
                                                 Random& random, const Grains<double>& grains) {
  if (!grains.masses.empty() || !grains.immobile.empty()) {
    return velocities_by_mass<Dim>(spheres, temperature, random, grains);
  }
  std::vector<Vec<Dim, double>> velocities(static_cast<std::size_t>(spheres));
  Vec<Dim, double> mean;
  for (auto& velocity : velocities) {
    for (int axis = 0; axis < Dim; ++axis) velocity[axis] = random.normal();
    mean += velocity * (1.0 / spheres);
  }
  double twice_energy = 0;
  for (auto& velocity : velocities) {
    if (spheres > 1) velocity -= mean;
    twice_energy += dot(velocity, velocity);
  }
  const double scale = twice_energy > 0 ? std::sqrt(temperature * Dim * spheres / twice_energy) : 0;
  for (auto& velocity : velocities) velocity *= scale;
  return velocities;
}

namespace {

template <int Dim>
std::vector<Vec<Dim, double>> random_places(const StartRequest& request,
                                            const ShearBox<Dim, double>& box, Random& random) {
  if (request.grains.diameters.empty()) {
    if (is_loose(request.spheres, box)) return loose_places<Dim>(request.spheres, box, random);
    const std::vector<double> ones(static_cast<std::size_t>(request.spheres), 1.0);
    return grown_places<Dim>(ones, box, random);
  }
  return grown_places<Dim>(request.grains.diameters, box, random);
}

/// Throws std::invalid_argument where spheres of different diameters overlap in their places.
void require_apart(const std::vector<Vec<3, double>>& places, const std::vector<double>& diameters,
                   const ShearBox<3, double>& box) {
  constexpr double margin = 0x1p-20;  // close_pairs() needs one
  for (const auto& pair : close_pairs<3>(places, diameters, box, margin)) {
    const auto i = static_cast<std::size_t>(pair.i);
    const auto j = static_cast<std::size_t>(pair.j);
    const Vec<3, double> apart = places[j] + pair.shift - places[i];
    const double reach = (diameters[i] + diameters[j]) / 2;
    if (dot(apart, apart) < reach * reach) {
      throw std::invalid_argument("spheres overlap on the lattice, with diameters of " +
                                  std::to_string(diameters[i]) + " and " +
                                  std::to_string(diameters[j]));
    }
  }
}

std::vector<Vec<3, double>> lattice_places(const StartRequest& request,
                                           const ShearBox<3, double>& box, Random& random) {
  std::vector<Vec<3, double>> places = fcc_lattice(request.spheres, box.sides()[0]);
  if (request.grains.are_alike()) return places;
  shuffle(places, random);
  if (!request.grains.diameters.empty()) require_apart(places, request.grains.diameters, box);
  return places;
}

}  // namespace

template <int Dim>
Configuration<Dim, double> make_start(const StartRequest& request,
                                      const ShearBox<Dim, double>& box) {
  Random random(request.seed);
  Configuration<Dim, double> start;
  if (request.arrangement == Arrangement::random) {
    start.positions = random_places<Dim>(request, box, random);
  } else {
    if constexpr (Dim == 3) start.positions = lattice_places(request, box, random);
  }
  start.velocities = thermal_velocities<Dim>(request.spheres, request.granular_temperature, random,
                                             request.grains);
  start.grains = request.grains;
  return start;
}

#define ZENOSPHERE_INSTANTIATE(Dim)                                                             \
  template std::vector<Vec<Dim, double>> thermal_velocities<Dim>(std::int32_t, double, Random&, \
                                                                 const Grains<double>&);        \
  template Configuration<Dim, double> make_start<Dim>(const StartRequest&,                      \
                                                      const ShearBox<Dim, double>&);
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
