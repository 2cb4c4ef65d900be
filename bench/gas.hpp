#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "engine/list_range.hpp"
#include "engine/simulation.hpp"
#include "engine/start.hpp"

namespace zenosphere::bench {

template <int Dim>
using Gas = Simulation<Dim, double>;

/// Some of the spheres are larger, of the same density; they come last.
struct LargeSpheres {
  std::int32_t count = 0;
  double diameter = 1;
};

/// The state that is measured: spheres in a periodic cube, or disks in a square, sheared or not.
struct GasRequest {
  StartRequest start;
  LargeSpheres large{};
  double solids_volume_fraction = 0;
  double restitution = 1;
  double shear_rate = 0;  ///< 1/time
};

/// What the spheres are; nothing where all are unit spheres.
///
/// \param mass  of a large one
inline Grains<double> grains(std::int32_t spheres, const LargeSpheres& large, double mass) {
  Grains<double> grains;
  if (large.count == 0) return grains;
  for (std::int32_t i = 0; i < spheres; ++i) {
    const bool is_large = i >= spheres - large.count;
    grains.diameters.push_back(is_large ? large.diameter : 1);
    grains.masses.push_back(is_large ? mass : 1);
    grains.kinds.push_back(is_large ? 1 : 0);
  }
  return grains;
}

/// The gas at time 0. Throws std::invalid_argument for disks on a lattice of spheres.
template <int Dim>
Gas<Dim> gas(GasRequest request) {
  if (Dim == 2 && request.start.arrangement == Arrangement::fcc) {
    throw std::invalid_argument("disks on an fcc lattice (must be --start random)");
  }
  const auto& [count, diameter] = request.large;
  const std::int32_t spheres = request.start.spheres;
  const double of_large = std::pow(diameter, Dim);  // volume, where that of the others is 1
  const double mean = (spheres + count * (of_large - 1)) / spheres;
  std::array<double, Dim> sides;
  sides.fill(box_side<Dim>(spheres, request.solids_volume_fraction) * std::pow(mean, 1.0 / Dim));
  request.start.grains = grains(spheres, request.large, of_large);
  const double width = fitting_cell_width({sides, spheres, sizes_of(request.start.grains)});
  const ShearBox<Dim, double> box({sides}, request.shear_rate, width);
  return {box, make_start<Dim>(request.start, box), {.restitution = request.restitution}};
}

/// The bare loop: collisions, and nothing that looks at them.
///
/// \return  the velocity changes summed up, so that no record is optimised away
template <int Dim>
double collide(Gas<Dim>& gas, std::int64_t collisions) {
  double sum = 0;
  const std::int64_t last = gas.collisions() + collisions;
  while (gas.collisions() < last) {
    const auto collision = gas.next_collision(std::numeric_limits<double>::max());
    if (collision) sum += collision->impact.impulse;
    if (gas.is_at_rest()) throw std::runtime_error("nothing moves any more");
  }
  return sum;
}

}  // namespace zenosphere::bench
