#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "export/cell.hpp"
#include "storage/records.hpp"

namespace zenosphere {

inline constexpr double sphere_radius = 0.5;  ///< diameters

/// One snapshot as viewers want it: in three dimensions, with its cell. Components that the run
/// does not have are 0.
struct Frame {
  std::int64_t number = 0;  ///< of the snapshot, from 0
  int dimension = 0;
  Snapshot snapshot{};
  Cell cell{};
  /// How often each sphere has collided since the start of the run; empty where that is not known.
  std::span<const std::int64_t> collisions{};

  std::int64_t spheres() const {
    return static_cast<std::int64_t>(snapshot.positions.size()) / dimension;
  }
  /// Laboratory position in the upright box, diameters.
  std::array<double, 3> position(std::int64_t i) const { return row(snapshot.positions, i); }
  /// Through how many boxes it has come since the start, along the vectors of the cell; only where
  /// has_images().
  std::array<std::int32_t, 3> image(std::int64_t i) const { return row(snapshot.images, i); }
  bool has_images() const { return !snapshot.images.empty(); }
  /// Laboratory velocity, diameters/time.
  std::array<double, 3> velocity(std::int64_t i) const { return row(snapshot.velocities, i); }

 private:
  template <class T>
  std::array<T, 3> row(const std::vector<T>& rows, std::int64_t i) const {
    std::array<T, 3> result{};
    const std::size_t first = static_cast<std::size_t>(i) * static_cast<std::size_t>(dimension);
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
      result[axis] = rows[first + axis];
    }
    return result;
  }
};

}  // namespace zenosphere
