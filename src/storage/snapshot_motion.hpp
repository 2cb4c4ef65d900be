#pragma once

#include <array>
#include <cstdint>

#include "model/grains.hpp"
#include "storage/records.hpp"

namespace zenosphere {

/// Velocity of sphere `i` of a snapshot relative to the imposed profile, diameters/time; components
/// that the run does not have are 0.
///
/// \param shear_rate  of the profile, 1/time; it is 0 in the middle of the box
std::array<double, 3> peculiar_velocity(const Snapshot& snapshot, int dimension, double shear_rate,
                                        std::int64_t i);

/// Sums over the mobile spheres of a snapshot, of their peculiar velocities c and masses m.
struct SnapshotMotion {
  std::array<double, 3> squares{};  ///< m c_a^2 of each component
  double shear = 0;                 ///< m c_x c_y
  double fastest = 0;               ///< largest c^2
  double mobile = 0;                ///< spheres that count

  /// Mean of m c^2 / D, mass (diameter/time)^2.
  double granular_temperature(int dimension) const {
    return (squares[0] + squares[1] + squares[2]) / (mobile * dimension);
  }
};

/// \param grains  masses, and which are immobile: those have no temperature
/// Source of the kinetic tensor <c c>: docs/theory.md.
SnapshotMotion motion_of(const Snapshot& snapshot, int dimension, double shear_rate,
                         const Grains<double>& grains);

}  // namespace zenosphere
