#pragma once

#include <vector>

#include "model/vec.hpp"

namespace zenosphere {

/// Places and peculiar velocities (relative to the imposed profile) of spheres.
///
/// At strain 0 the images of the box lie on a square grid; later the images along y are displaced
/// by the Lees-Edwards offset.
template <int Dim, class Real>
struct Configuration {
  std::vector<Vec<Dim, Real>> positions;   ///< in [0, side) along each axis, diameters
  std::vector<Vec<Dim, Real>> velocities;  ///< peculiar, diameters/time
};

}  // namespace zenosphere
