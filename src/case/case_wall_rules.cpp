#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "case/case_box.hpp"
#include "case/case_grains.hpp"
#include "case/case_rules.hpp"
#include "case/case_speeds.hpp"
#include "case/case_words.hpp"
#include "case/resting_flight.hpp"
#include "case/wall_motion.hpp"

namespace zenosphere::case_format {
namespace {

using Objection = std::optional<std::string>;

bool has_box(const Case& values) {
  return !values.system.sides.empty() || values.system.solids_volume_fraction > 0;
}

/// The walls leave room for the largest sphere where the lower one is at its highest.
Objection wall_reaches_the_other(const Case& values) {
  if (!values.walls.motion || !has_box(values)) return std::nullopt;
  const int axis = *closed_axis(values);
  const double side = box_sides(values)[static_cast<std::size_t>(axis)];
  const double room = side - values.system.sizes.largest;
  if (2 * values.walls.amplitude < room) return std::nullopt;
  return fmt::format(
      "(the wall rises by twice that, and the box side along {} less a sphere is {:.6g} "
      "diameters); "
      "use less than {:.6g}",
      axis_letter(axis), room, room / 2);
}

/// The wall and the shortest flights of a sphere that rests on it are resolved by the clock, which
/// counts whole time units and the rest.
Objection frequency_out_of_range(const Case& values) {
  const auto& walls = values.walls;
  if (!walls.motion) return std::nullopt;
  constexpr double most_rounded = 1e-6;
  const double speed = peak_speed(walls);
  if (!(speed >= slowest && speed <= fastest)) {
    return fmt::format(
        "(the peak speed of the wall is {:.3g} diameters/time, must be in [{:g}, {:g}]); choose "
        "another unit of time",
        speed, slowest, fastest);
  }
  const double rounding = std::ldexp(1.0, 1 - values.collision.precision.bits());
  const double shortest = walls.resting_flight > 0 ? walls.resting_flight : 1.0;
  const double most = most_rounded / rounding * std::min(shortest, walls.frequency / speed);
  if (walls.frequency <= most) return std::nullopt;
  return fmt::format(
      "(in {} the clock would not resolve the motion of the wall, must be at most {:.3g}); choose "
      "another unit of time or more digits in collision.precision",
      word(values.collision.precision), most);
}

/// The hops of a sphere that rests on the wall are no separation hits, and the clock resolves them.
Objection hops_too_low(const Case& values) {
  const auto& walls = values.walls;
  if (!walls.motion || !(walls.resting_flight > 0)) return std::nullopt;
  const auto& acceleration = values.gravity.acceleration;
  const auto axis = static_cast<std::size_t>(*closed_axis(values));
  const double gravity = axis < acceleration.size() ? -acceleration[axis] : 0.0;
  const double peak = peak_acceleration(walls);
  const double flight =
      longest_resting_flight(walls.resting_flight, 1 / walls.frequency, peak, gravity);
  const double height = (peak + std::max(gravity, 0.0)) * flight * flight / 8;
  constexpr double clear = 100;  // gravity and wall nearly cancel at times: the hops are lower then
  const double least = clear * values.collapse.gap_threshold.nearest_double();
  const double most_rounded = 1e-6;
  const double shortest = std::ldexp(1.0, 1 - values.collision.precision.bits()) / most_rounded;
  if (height >= least && flight >= shortest) return std::nullopt;
  const double factor =
      std::max(std::sqrt(least / height), flight > 0 ? shortest / flight : fastest);
  const double enough = walls.resting_flight * factor;
  constexpr double longest = 1e-3;  // that the key takes
  return fmt::format(
      "(a sphere that rests would hop {:.3g} diameters high for a time of {:.3g}, which {}); {}",
      height, flight,
      height < least ? "is not 100 times collapse.gap_threshold" : "the clock would not resolve",
      enough <= longest ? fmt::format("set walls.resting_flight to at least {:.3g}, or 0", enough)
                        : std::string("set walls.resting_flight to 0"));
}

Objection oscillation_of_immobile_spheres(const Case& values) {
  const auto is_immobile = [](const Species& species) { return species.immobile; };
  if (!values.walls.motion ||
      std::none_of(values.species.begin(), values.species.end(), is_immobile)) {
    return std::nullopt;
  }
  return "(not together with an immobile species, which the wall would run into); remove one of "
         "the two";
}

Objection thermal_temperature_out_of_range(const std::optional<double>& temperature,
                                           const Case& values) {
  if (!temperature) return std::nullopt;
  const double speed = std::sqrt(*temperature);
  if (!(speed >= slowest && speed <= fastest)) {
    return fmt::format("(must be in [{:g}, {:g}]); choose another unit of time", slowest * slowest,
                       fastest * fastest);
  }
  if (!is_rough(values)) return std::nullopt;
  return "(thermal walls are for smooth spheres in this version); remove it or the friction of the "
         "spheres";
}

Objection lower_temperature_of_no_use(const Case& values) {
  const auto& temperature = values.walls.lower_temperature;
  if (const auto objection = thermal_temperature_out_of_range(temperature, values)) {
    return objection;
  }
  if (!temperature || !values.walls.motion) return std::nullopt;
  return "(a wall either oscillates or is thermal); remove it or walls.motion";
}

Objection upper_temperature_of_no_use(const Case& values) {
  return thermal_temperature_out_of_range(values.walls.upper_temperature, values);
}

}  // namespace

std::span<const Rule> wall_rules() {
  static const std::vector<Rule> rules{
      {{"walls.motion", "walls.axis"}, oscillation_of_immobile_spheres},
      {{"walls.amplitude", "walls.motion", "walls.axis", "system.dimension", "system.sides",
        "system.solids_volume_fraction", "system.aspect_ratio", "system.spheres"},
       wall_reaches_the_other},
      {{"walls.frequency", "walls.motion", "walls.amplitude", "walls.resting_flight",
        "collision.precision"},
       frequency_out_of_range},
      {{"walls.amplitude", "walls.axis", "walls.motion", "walls.resting_flight", "walls.frequency",
        "gravity.acceleration", "collapse.gap_threshold", "collision.precision"},
       hops_too_low},
      {{"walls.lower_temperature", "walls.axis", "walls.motion", "collision.friction"},
       lower_temperature_of_no_use},
      {{"walls.upper_temperature", "walls.axis", "collision.friction"},
       upper_temperature_of_no_use}};
  return rules;
}

}  // namespace zenosphere::case_format
