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

using Gas = Simulation<3, double>;

/// Some of the spheres are larger, of the same density; they come last.
struct LargeSpheres {
  std::int32_t count = 0;
  double diameter = 1;
};

/// The state that is measured: spheres in a periodic cube, sheared or not.
struct GasRequest {
  StartRequest start;
  LargeSpheres large{};
  double solids_volume_fraction = 0;
  double restitution = 1;
  double shear_rate = 0;  ///< 1/time
};

/// What the spheres are; nothing where all are unit spheres.
inline Grains<double> grains(std::int32_t spheres, const LargeSpheres& large) {
  Grains<double> grains;
  if (large.count == 0) return grains;
  const double volume = large.diameter * large.diameter * large.diameter;
  for (std::int32_t i = 0; i < spheres; ++i) {
    const bool is_large = i >= spheres - large.count;
    grains.diameters.push_back(is_large ? large.diameter : 1);
    grains.masses.push_back(is_large ? volume : 1);
    grains.kinds.push_back(is_large ? 1 : 0);
  }
  return grains;
}

/// The gas at time 0.
inline Gas gas(GasRequest request) {
  const auto& [count, diameter] = request.large;
  const std::int32_t spheres = request.start.spheres;
  const double volume = spheres + count * (diameter * diameter * diameter - 1);
  const double side =
      box_side<3>(spheres, request.solids_volume_fraction) * std::cbrt(volume / spheres);
  const std::array sides{side, side, side};
  request.start.grains = grains(spheres, request.large);
  const double width = fitting_cell_width({sides, spheres, sizes_of(request.start.grains)});
  const ShearBox<3, double> box({sides}, request.shear_rate, width);
  return Gas(box, make_start<3>(request.start, box), {.restitution = request.restitution});
}

/// The bare loop: collisions, and nothing that looks at them.
///
/// \return  the velocity changes summed up, so that no record is optimised away
inline double collide(Gas& gas, std::int64_t collisions) {
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
