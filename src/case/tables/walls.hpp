#pragma once

#include <array>
#include <optional>

#include "case/tables/friction.hpp"
#include "case/tables/system.hpp"
#include "model/case_key.hpp"
#include "model/oscillation.hpp"
#include "model/word_table.hpp"

namespace zenosphere {

enum class Axis { x, y, z };
inline constexpr std::array axis_words{Word{"x", Axis::x}, Word{"y", Axis::y}, Word{"z", Axis::z}};
inline const auto& words_of(Axis) { return axis_words; }

inline constexpr std::array motion_words{Word{"sinusoidal", OscillationShape::sinusoidal},
                                         Word{"parabolic", OscillationShape::parabolic}};
inline const auto& words_of(OscillationShape) { return motion_words; }

namespace case_format {

// Far above the rounding of places, of which the wall has to be clear.
inline constexpr double least_amplitude = 1e-9;
// A sphere that rests is let go a thousand times in a period at least: its height is 1e-6 of the
// way of the wall then.
inline constexpr double most_resting_flight = 1e-3;

inline constexpr When only_walled{
    "walls.axis", "", [](const auto& c) { return c.walls.axis.has_value(); }, "walls with an axis"};
inline constexpr When only_touched{
    "walls.axis", "system.dimension",
    [](const auto& c) { return c.walls.axis.has_value() && c.system.dimension > 1; },
    "walls in two or three dimensions"};
inline constexpr When only_sliding{
    "walls.axis", "",
    [](const auto& c) { return c.walls.axis.has_value() && c.walls.axis != Axis::x; },
    "walls normal to y or z, which can move along x"};
inline constexpr When only_oscillating{
    "walls.motion", "", [](const auto& c) { return c.walls.motion.has_value(); }, "a walls.motion"};

/// The table [walls]: two walls that replace a periodic boundary.
struct Walls {
  std::optional<Axis> axis;  ///< normal of the walls; none: no walls
  double restitution = 1;
  double tangential_restitution = -1;  ///< -1 smooth, 0 the sphere takes the wall's velocity
  std::optional<Friction> friction{};  ///< of rough spheres; none: unbounded
  double lower_speed = 0;              ///< of the wall along x, diameters/time
  double upper_speed = 0;
  std::optional<OscillationShape> motion{};  ///< of the lower wall along the axis; none: it rests
  double amplitude = 0;                      ///< diameters
  double frequency = 0;                      ///< 1/time
  double resting_flight = 1e-4;  ///< of a sphere that rests on it, periods; 0: it cannot rest
  std::optional<double> lower_temperature{};  ///< mass (diameter/time)^2; none: not thermal
  std::optional<double> upper_temperature{};

  template <class Visitor>
  void keys(Visitor&& visit) {
    keys_of_contact(visit);
    keys_of_motion(visit);
    visit(CaseKey{"lower_temperature", optional, above(0),
                  "makes the lower wall a thermal one [mass diameter^2/time^2]"},
          lower_temperature, only_walled);
    visit(CaseKey{"upper_temperature", optional, above(0),
                  "makes the upper wall a thermal one [mass diameter^2/time^2]"},
          upper_temperature, only_walled);
  }

 private:
  template <class Visitor>
  void keys_of_contact(Visitor& visit) {
    visit(CaseKey{"axis", with_table, any,
                  "normal of the two walls that replace the periodic boundary"},
          axis);
    visit(CaseKey{"restitution", with_table, from_to(0, 1, "1 is elastic"),
                  "normal speed after a wall / before"},
          restitution, only_walled);
    visit(CaseKey{"tangential_restitution", optional, from_to(-1, 1, "-1 is smooth"),
                  "- tangential speed against the wall after / before"},
          tangential_restitution, only_touched);
    visit(CaseKey{"friction", optional, from_to(0, most_friction, "or \"unbounded\""),
                  "tangential impulse of a rough sphere that slides on a wall / normal impulse"},
          friction, only_touched);
  }
  template <class Visitor>
  void keys_of_motion(Visitor& visit) {
    visit(CaseKey{"lower_speed", optional, any, "of the lower wall, along x [diameters/time]"},
          lower_speed, only_sliding);
    visit(CaseKey{"upper_speed", optional, any, "of the upper wall, along x [diameters/time]"},
          upper_speed, only_sliding);
    visit(CaseKey{"motion", optional, any,
                  "of the lower wall along the axis, from its lowest place, 0, and back"},
          motion, only_walled);
    visit(CaseKey{"amplitude", required, from_to(least_amplitude, largest_side),
                  "of that motion: half the way from the lowest to the highest place [diameters]"},
          amplitude, only_oscillating);
    visit(
        CaseKey{"frequency", required, above(0), "of that motion: periods in a time unit [1/time]"},
        frequency, only_oscillating);
    visit(CaseKey{"resting_flight", optional, from_to(0, most_resting_flight, "0 is off"),
                  "a sphere that would be back on that wall sooner is let go for so long "
                  "[periods]"},
          resting_flight, only_oscillating);
  }
};

}  // namespace case_format
}  // namespace zenosphere
