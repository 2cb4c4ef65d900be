#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "export/cell.hpp"
#include "model/grains.hpp"
#include "storage/records.hpp"

namespace zenosphere {

/// One snapshot as viewers want it: in three dimensions, with its cell. Components that the run
/// does not have are 0.
struct Frame {
  std::int64_t number = 0;  ///< of the snapshot, from 0
  int dimension = 0;
  Snapshot snapshot{};
  Cell cell{};
  /// How often each sphere has collided since the start of the run; empty where that is not known.
  std::span<const std::int64_t> collisions{};
  const Grains<double>* grains = nullptr;  ///< what the spheres are; null: unit spheres
  std::span<const std::string> species{};  ///< names of their kinds
  double reduced_inertia = 0;              ///< q = 4 I / (m s^2) of rough spheres
  double shear_rate = 0;                   ///< of the imposed profile, 1/time

  std::int64_t spheres() const {
    return static_cast<std::int64_t>(snapshot.positions.size()) / dimension;
  }
  bool are_alike() const { return !grains || grains->are_alike(); }
  double radius(std::int64_t i) const {
    return are_alike() ? 0.5 : grains->radius(static_cast<std::int32_t>(i));
  }
  double mass(std::int64_t i) const {
    return are_alike() ? 1 : grains->mass(static_cast<std::int32_t>(i));
  }
  /// From 0, in the order of the case.
  std::int64_t kind(std::int64_t i) const {
    return are_alike() ? 0 : grains->kind(static_cast<std::int32_t>(i));
  }
  bool is_immobile(std::int64_t i) const {
    return !are_alike() && grains->is_immobile(static_cast<std::int32_t>(i));
  }
  bool has_spins() const { return !snapshot.angular_velocities.empty(); }
  /// Angular velocity, radians/time; only where has_spins(). In two dimensions along z.
  std::array<double, 3> spin(std::int64_t i) const {
    const auto at = static_cast<std::size_t>(i);
    const auto& all = snapshot.angular_velocities;
    if (dimension < 3) return {0, 0, all[at]};
    return {all[3 * at], all[3 * at + 1], all[3 * at + 2]};
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
