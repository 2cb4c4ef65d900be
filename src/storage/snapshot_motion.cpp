#include "storage/snapshot_motion.hpp"

#include <algorithm>

namespace zenosphere {

std::array<double, 3> peculiar_velocity(const Snapshot& snapshot, int dimension, double shear_rate,
                                        std::int64_t i) {
  const auto axes = static_cast<std::size_t>(dimension);
  const std::size_t first = static_cast<std::size_t>(i) * axes;
  std::array<double, 3> velocity{};
  for (std::size_t axis = 0; axis < axes; ++axis) {
    velocity[axis] = snapshot.velocities[first + axis];
  }
  if (dimension > 1) {
    const double middle = snapshot.box_edges[axes + 1] / 2;
    velocity[0] -= shear_rate * (snapshot.positions[first + 1] - middle);
  }
  return velocity;
}

SnapshotMotion motion_of(const Snapshot& snapshot, int dimension, double shear_rate,
                         const Grains<double>& grains) {
  SnapshotMotion motion;
  const auto spheres = static_cast<std::int64_t>(snapshot.velocities.size()) / dimension;
  for (std::int64_t i = 0; i < spheres; ++i) {
    const auto sphere = static_cast<std::int32_t>(i);
    if (grains.is_immobile(sphere)) continue;
    ++motion.mobile;
    const auto velocity = peculiar_velocity(snapshot, dimension, shear_rate, i);
    const double mass = grains.mass(sphere);
    double square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double part = velocity[axis] * velocity[axis];
      motion.squares[axis] += mass * part;
      square += part;
    }
    motion.shear += mass * velocity[0] * velocity[1];
    motion.fastest = std::max(motion.fastest, square);
  }
  return motion;
}

}  // namespace zenosphere
