#pragma once

#include <optional>
#include <vector>

namespace zenosphere {

/// Time averages of a run from `from_time` to `to_time`.
///
/// Units: diameter = mass = 1, times in the case's unit. All velocities are peculiar: relative to
/// the imposed profile, and of mobile spheres: immobile ones have no temperature. In D dimensions a
/// pressure is in mass/(diameter^(D-2) time^2).
struct Averages {
  double granular_temperature = 0;           ///< mean of m v.v/D, mass (diameter/time)^2
  std::vector<double> temperature_diagonal;  ///< D values
  double pressure = 0;                       ///< trace of the pressure tensor / D
  std::vector<double> pressure_tensor;       ///< D x D values, row-major, kinetic + collisional
  double collision_rate = 0;                 ///< collisions per sphere per time
  double dissipation = 0;                    ///< energy lost in collisions per volume and time
  double shear_work = 0;                     ///< -P_xy shear_rate: work per volume and time
  double other_work = 0;                     ///< of gravity, walls and kicks, per volume and time
  std::vector<double> wall_pressure;         ///< on the lower and the upper wall; else empty
  double compressibility_factor = 0;         ///< pressure / (number density x temperature)
  double normal_speed = 0;                   ///< mean closing speed of the collisions
  std::optional<double> rotational_temperature{};  ///< mean of I w^2 over the axes; of spins
  std::vector<double> temperature_of_kind{};       ///< each, where there are several kinds
  std::vector<double> rotational_temperature_of_kind{};
  double from_time = 0;
  double to_time = 0;
};

}  // namespace zenosphere
