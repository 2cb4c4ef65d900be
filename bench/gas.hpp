#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "engine/settling.hpp"
#include "engine/simulation.hpp"
#include "engine/start.hpp"

namespace zenosphere::bench {

using Gas = Simulation<3, double>;

/// The state that is measured: spheres in a periodic cube, sheared or not.
struct GasRequest {
  StartRequest start;
  double solids_volume_fraction = 0;
  double restitution = 1;
  double shear_rate = 0;  ///< 1/time
};

/// The gas at time 0.
inline Gas gas(const GasRequest& request) {
  const double side = box_side<3>(request.start.spheres, request.solids_volume_fraction);
  const std::array sides{side, side, side};
  const ShearBox<3, double> box({sides}, request.shear_rate,
                                fitting_cell_width({sides, request.start.spheres}));
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
