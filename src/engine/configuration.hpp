#pragma once

#include <vector>

#include "model/grains.hpp"
#include "model/spin.hpp"
#include "model/vec.hpp"

namespace zenosphere {

/// Places and peculiar velocities (relative to the imposed profile) of spheres in a periodic box.
template <int Dim, class Real>
struct Configuration {
  std::vector<Vec<Dim, Real>> positions;   ///< in [0, side) along each axis, diameters
  std::vector<Vec<Dim, Real>> velocities;  ///< peculiar, diameters/time

  /// The Lees-Edwards offset: displacement of the upper image of the box along x, in
  /// [-side/2, side/2), diameters. 0 where the images lie on an upright grid.
  Real offset = 0;

  /// Through how many boxes each sphere has come since the start, along the three box vectors:
  /// whole numbers. Of a start it does not count.
  std::vector<Vec<Dim, double>> boxes{};

  /// What the spheres are; empty: unit spheres of one kind.
  Grains<Real> grains{};

  /// Angular velocities, radians/time; empty: they do not turn.
  std::vector<Spin<Dim, Real>> spins{};
};

}  // namespace zenosphere
