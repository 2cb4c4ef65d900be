#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/field.hpp"

namespace zenosphere {

enum class Shape { number, row, matrix };

/// How the averages of two spans of time combine into that of both.
enum class Mean {
  over_time,        ///< their mean
  over_collisions,  ///< weighted with the collision rate
  over_thermal,     ///< weighted with the granular temperature
  over_pressure,    ///< weighted with the pressure
  of_squares,       ///< the root of the mean square
};

/// What is measured in a run, as averages over some time.
///
/// Units: diameter = mass = 1, times in the case's unit. All velocities are peculiar: relative to
/// the imposed profile, and of mobile spheres: immobile ones have no temperature. In D dimensions a
/// pressure is in mass/(diameter^(D-2) time^2).
struct Observables {
  double granular_temperature = 0;             ///< mean of m v.v/D, mass (diameter/time)^2
  std::vector<double> temperature_diagonal{};  ///< D values
  double pressure = 0;                         ///< trace of the pressure tensor / D
  std::vector<double> pressure_tensor{};       ///< D x D values, row-major, kinetic + collisional
  double collision_rate = 0;                   ///< collisions per sphere per time
  double dissipation = 0;                      ///< energy lost in collisions per volume and time
  double compressibility_factor = 0;           ///< pressure / (number density x temperature)
  double shear_work = 0;                       ///< -P_xy shear_rate: work per volume and time
  double normal_speed = 0;                     ///< mean closing speed of the collisions
  double other_work = 0;                       ///< of gravity, walls, kicks, per volume and time
  std::vector<double> wall_pressure{};         ///< on the lower and the upper wall; else empty
  std::vector<double> wall_work{};  ///< of each, where one oscillates or is thermal: the energy
                                    ///< that it gives, per area and time
  /// Under shear: (P_xx - P_yy)/pressure and, in three dimensions, (P_yy - P_zz)/pressure.
  std::vector<double> normal_stress_differences{};
  /// Second Sonine coefficient, 0 for Maxwellian velocities: sonine.hpp. Of spheres that are alike,
  /// without walls; a mean over the ends of the intervals, NaN where there is none.
  std::optional<double> sonine_a2{};
  std::vector<double> streak_modes{};  ///< amplitudes, root mean square, diameter/time: streaks.hpp
  std::optional<double> rotational_temperature{};  ///< mean of I w^2 over the axes; of spins
  std::vector<double> temperature_of_kind{};       ///< each, where there are several kinds
  std::vector<double> rotational_temperature_of_kind{};

  /// Calls `visit(name, member, shape, mean)` for each of them: the one list from which JSON,
  /// errors, the series of a run and its columns come.
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    constexpr auto number = Shape::number;
    visit("granular_temperature", self.granular_temperature, number, Mean::over_time);
    visit("temperature_diagonal", self.temperature_diagonal, Shape::row, Mean::over_time);
    visit("pressure", self.pressure, number, Mean::over_time);
    visit("pressure_tensor", self.pressure_tensor, Shape::matrix, Mean::over_time);
    visit("collision_rate", self.collision_rate, number, Mean::over_time);
    visit("dissipation", self.dissipation, number, Mean::over_time);
    visit("compressibility_factor", self.compressibility_factor, number, Mean::over_thermal);
    visit("shear_work", self.shear_work, number, Mean::over_time);
    visit("normal_speed", self.normal_speed, number, Mean::over_collisions);
    visit("other_work", self.other_work, number, Mean::over_time);
    visit("wall_pressure", self.wall_pressure, Shape::row, Mean::over_time);
    visit("wall_work", self.wall_work, Shape::row, Mean::over_time);
    visit("normal_stress_differences", self.normal_stress_differences, Shape::row,
          Mean::over_pressure);
    visit("sonine_a2", self.sonine_a2, number, Mean::over_time);
    visit("streak_modes", self.streak_modes, Shape::row, Mean::of_squares);
    visit("rotational_temperature", self.rotational_temperature, number, Mean::over_time);
    visit("temperature_of_kind", self.temperature_of_kind, Shape::row, Mean::over_time);
    visit("rotational_temperature_of_kind", self.rotational_temperature_of_kind, Shape::row,
          Mean::over_time);
  }
};

/// Time averages of a run from `from_time` to `to_time`, and how far they can be trusted.
struct Averages : Observables {
  double from_time = 0;
  double to_time = 0;

  /// Of each average; NaN where the run is too short to tell. None where there was no series.
  std::optional<Observables> standard_error{};
  /// Independent values in the series of that average which has the fewest, rounded; none: unknown.
  std::optional<std::int64_t> blocks{};

  std::optional<bool> steady{};  ///< none: the run is too short to tell
  std::string steady_reason{};   ///< one sentence

  std::optional<double> streak_amplitude{};            ///< of the strongest mode, diameter/time
  std::optional<double> temperature_without_streak{};  ///< granular; both under shear only

  /// What is said of the observables together, without them and their errors.
  template <class Self, class Visitor>
  static void remarks(Self& self, Visitor&& visit) {
    visit(Field{"from_time", "averages_from_time"}, self.from_time);
    visit(Field{"to_time", "averages_to_time"}, self.to_time);
    visit(Field{"blocks", "averages_blocks", true}, self.blocks);
    visit(Field{"steady", "averages_steady", true}, self.steady);
    visit(Field{"steady_reason", "averages_steady_reason", true}, self.steady_reason);
    visit(Field{"streak_amplitude", "streak_amplitude", true}, self.streak_amplitude);
    visit(Field{"temperature_without_streak", "temperature_without_streak", true},
          self.temperature_without_streak);
  }
};

}  // namespace zenosphere
