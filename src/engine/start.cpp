#include "engine/start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "engine/loose_packing.hpp"
#include "engine/simulation.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

std::vector<Vec<3, double>> fcc_lattice(std::int32_t spheres, double side) {
  constexpr double kBasis[4][3] = {{0, 0, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}};
  int n = 0;
  while (4 * n * n * n < spheres) ++n;
  if (4 * n * n * n != spheres) throw std::invalid_argument("fcc needs 4 n^3 spheres");
  const double spacing = side / n;
  std::vector<Vec<3, double>> positions;
  positions.reserve(static_cast<std::size_t>(spheres));
  for (int z = 0; z < n; ++z) {
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        for (const auto& site : kBasis) {
          // A quarter of a spacing away from the faces of the box, so that no sphere is on one.
          positions.push_back({(x + site[0] + 0.25) * spacing, (y + site[1] + 0.25) * spacing,
                               (z + site[2] + 0.25) * spacing});
        }
      }
    }
  }
  return positions;
}

/// Random places: overlaps pushed apart, then mixed by elastic collisions at unit temperature.
template <int Dim>
std::vector<Vec<Dim, double>> random_places(std::int32_t spheres, const ShearBox<Dim, double>& box,
                                            Random& random) {
  // At 0.3 the pushing is forgotten after a few collisions per sphere; at 0.5 the pressure is 3 %
  // too high for the first time unit and settles within the next half.
  constexpr std::int64_t kMixingCollisionsPerSphere = 20;
  constexpr double kMixingTime = 1.5;
  Configuration<Dim, double> state;
  state.positions = loose_packing<Dim>(spheres, box, random);
  state.velocities = thermal_velocities<Dim>(spheres, 1.0, random);
  Surroundings<Dim, double> surroundings;
  if (const auto axis = box.closed_axis()) surroundings.walls = Walls<double>{.axis = *axis};
  const ShearBox<Dim, double> still(box.sides(), 0, fitting_cell_width(box.volume(), spheres, Dim),
                                    box.closed_axis());
  Simulation<Dim, double> mixing(still, state, {1.0}, surroundings);
  const std::int64_t collisions = kMixingCollisionsPerSphere * spheres / 2;
  // A gas too thin to collide is mixed already: a unit speed crosses the box in its side.
  double longest = 0;
  for (int axis = 0; axis < Dim; ++axis) longest = std::max(longest, 20 * box.sides()[axis]);
  const auto is_mixed = [&] {
    return mixing.collisions() >= collisions && mixing.has_reached(kMixingTime);
  };
  while (!is_mixed() && !mixing.has_reached(longest)) {
    mixing.next_collision(longest);
  }
  return mixing.configuration().positions;
}

}  // namespace

template <int Dim>
std::vector<Vec<Dim, double>> thermal_velocities(std::int32_t spheres, double temperature,
                                                 Random& random) {
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

template <int Dim>
Configuration<Dim, double> make_start(const StartRequest& request,
                                      const ShearBox<Dim, double>& box) {
  Random random(request.seed);
  Configuration<Dim, double> start;
  if (request.arrangement == Arrangement::random) {
    start.positions = random_places<Dim>(request.spheres, box, random);
  } else {
    if constexpr (Dim == 3) start.positions = fcc_lattice(request.spheres, box.sides()[0]);
  }
  start.velocities = thermal_velocities<Dim>(request.spheres, request.granular_temperature, random);
  return start;
}

#define ZENOSPHERE_INSTANTIATE(Dim)                                                              \
  template std::vector<Vec<Dim, double>> thermal_velocities<Dim>(std::int32_t, double, Random&); \
  template Configuration<Dim, double> make_start<Dim>(const StartRequest&,                       \
                                                      const ShearBox<Dim, double>&);
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
