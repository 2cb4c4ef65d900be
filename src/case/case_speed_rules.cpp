#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "case/case_box.hpp"
#include "case/case_rules.hpp"
#include "case/case_speeds.hpp"
#include "case/case_words.hpp"

namespace zenosphere::case_format {
namespace {

using Objection = std::optional<std::string>;

/// Most kicks and most snapshots of a run: as many as collisions, each count exact in a double.
constexpr double most_intervals = 1e15;

/// Part of the thermal speed that the rounding of a larger speed may be.
constexpr double most_rounding = 0.01;

/// Diameters by which the rounding of a time may misplace a sphere. The self-check lets pass more.
constexpr double most_misplaced = 1e-6;

/// Distance from 1 to the next number.
double rounding_of(Precision precision) { return std::ldexp(1.0, 1 - precision.bits()); }

/// `must be 0 or in [1e-75, 1e+75]`
std::string range_text() { return fmt::format("must be 0 or in [{:g}, {:g}]", slowest, fastest); }

bool is_right(double speed) {
  return speed == 0 || (std::abs(speed) >= slowest && std::abs(speed) <= fastest);
}

/// `(what is 1e+120 diameters/time, must be 0 or in ...)` where it is not.
Objection unless_right(double speed, std::string_view what) {
  if (is_right(speed)) return std::nullopt;
  return fmt::format("({} is {:.3g} diameters/time, {}); choose another unit of time", what, speed,
                     range_text());
}

double side_along(const Case& values, int axis) {
  return box_sides(values)[static_cast<std::size_t>(axis)];
}

bool has_box(const Case& values) {
  return !values.system.sides.empty() || values.system.solids_volume_fraction > 0;
}

Objection temperature_out_of_range(const Case& values) {
  if (is_right(std::sqrt(values.start.granular_temperature.value_or(0)))) return std::nullopt;
  return fmt::format("(must be 0 or in [{:g}, {:g}]); choose another unit of time",
                     slowest * slowest, fastest * fastest);
}

/// That of the spheres at the start; 0 where they rest, or are read from a file: given_start()
/// judges these.
double thermal_speed_at_start(const Case& values) {
  const auto& start = values.start;
  if (start.granular_temperature) return std::sqrt(*start.granular_temperature);
  if (start.velocities.size() != start.positions.size() || !has_box(values)) return 0;
  return thermal_speed(values, flat(start.positions), flat(start.velocities));
}

Objection written_speeds_out_of_range(const Case& values) {
  const auto wrong = wrong_speed(flat(values.start.velocities), values.system.dimension);
  return wrong ? Objection(fmt::format("({}); choose another unit of time", *wrong)) : std::nullopt;
}

double speed_across(const Case& values) {
  const bool is_sheared = values.drive.kind == DriveKind::shear && values.system.dimension > 1;
  return is_sheared && has_box(values) ? values.drive.shear_rate * side_along(values, 1) : 0;
}

Objection shear_out_of_range(const Case& values) {
  return unless_right(speed_across(values), "the speed across the box");
}

/// What of the speeds of a start is less than the rounding of the profile is lost.
Objection shear_drowns_temperature(const Case& values) {
  const double thermal = thermal_speed_at_start(values);
  const double across = speed_across(values);
  const double rounding = rounding_of(values.collision.precision);
  const double most = most_rounding * thermal / rounding;
  if (thermal == 0 || across <= most) return std::nullopt;
  return fmt::format(
      "(the speed across the box is rounded to {:.2g} in {}, the thermal speed is {:.3g}); use at "
      "most {:.3g}, a hotter start or more digits in collision.precision",
      across * rounding, word(values.collision.precision), thermal,
      0.994 * most / side_along(values, 1));  // below it in three digits
}

Objection gravity_out_of_range(const Case& values) {
  const auto& acceleration = values.gravity.acceleration;
  if (!has_box(values)) return std::nullopt;
  for (std::size_t axis = 0; axis < acceleration.size(); ++axis) {
    const double speed = std::sqrt(std::abs(acceleration[axis])) *
                         std::sqrt(2 * side_along(values, static_cast<int>(axis)));
    if (const auto wrong = unless_right(speed, "the speed after a fall through the box")) {
      return wrong;
    }
  }
  return std::nullopt;
}

/// Where no wall stops it, gravity makes all spheres equally fast: that must be a speed, and leave
/// the digits of what they do among each other.
Objection fall_drowns_temperature(const Case& values) {
  const double thermal = thermal_speed_at_start(values);
  const double time = values.run.time.value_or(0);
  const double most = most_rounding * thermal / rounding_of(values.collision.precision);
  const auto& acceleration = values.gravity.acceleration;
  for (std::size_t axis = 0; axis < acceleration.size(); ++axis) {
    const double speed = std::abs(acceleration[axis]) * time;
    if (closed_axis(values) == static_cast<int>(axis)) continue;
    if (speed > fastest) return unless_right(speed, "the speed of the fall at run.time");
    if (thermal == 0 || speed <= most) continue;
    return fmt::format(
        "(all fall at {:.3g} diameters/time at run.time, which is rounded to {:.2g} in {}; the "
        "thermal speed is {:.3g}); end the run earlier or use more digits in collision.precision",
        speed, speed * rounding_of(values.collision.precision), word(values.collision.precision),
        thermal);
  }
  return std::nullopt;
}

Objection kicks_out_of_range(const Case& values) {
  const auto& drive = values.drive;
  if (drive.kind != DriveKind::random) return std::nullopt;
  const double strength = std::sqrt(drive.noise_strength);
  if (auto wrong = unless_right(strength * std::sqrt(drive.kick_interval), "the speed of a kick")) {
    return wrong;
  }
  const double flown = strength * std::sqrt(drive.kick_interval) * drive.kick_interval;
  const double misplaced = flown * rounding_of(values.collision.precision);
  if (misplaced > most_misplaced) {
    return fmt::format(
        "(a sphere flies {:.3g} diameters between kicks, which is rounded to {:.2g} in {}, must be "
        "at most {:g}); kick more often or use more digits in collision.precision",
        flown, misplaced, word(values.collision.precision), most_misplaced);
  }
  const double time = std::max(values.run.time.value_or(0), drive.kick_interval);
  return unless_right(strength * std::sqrt(time), "the speed that all kicks give a sphere");
}

/// What a sphere gets of a rough wall must leave it a place when it first meets the wall, at a time
/// that is known to some digits only.
Objection wall_out_of_range(double speed, const Case& values) {
  if (const auto wrong = unless_right(speed, "it")) return wrong;
  const double thermal = thermal_speed_at_start(values);
  const bool is_rough = values.walls.tangential_restitution > -1;
  if (thermal == 0 || !is_rough || !values.walls.axis || !has_box(values)) return std::nullopt;
  const double until_wall = side_along(values, *closed_axis(values)) / thermal;
  const double misplaced = std::abs(speed) * until_wall * rounding_of(values.collision.precision);
  if (misplaced <= most_misplaced) return std::nullopt;
  return fmt::format(
      "(beside a thermal speed of {:.3g} the rounding of time in {} is {:.2g} diameters, must be "
      "at most {:g}); use a slower wall or more digits in collision.precision",
      thermal, word(values.collision.precision), misplaced, most_misplaced);
}

Objection lower_wall_out_of_range(const Case& values) {
  return wall_out_of_range(values.walls.lower_speed, values);
}

Objection upper_wall_out_of_range(const Case& values) {
  return wall_out_of_range(values.walls.upper_speed, values);
}

Objection too_often(double interval, const Case& values) {
  const double time = values.run.time.value_or(0);
  if (!(time / interval > most_intervals)) return std::nullopt;
  return fmt::format("(more than {:g} until run.time = {}); use a longer one", most_intervals,
                     time);
}

Objection kicks_too_often(const Case& values) {
  const bool is_kicked = values.drive.kind == DriveKind::random;
  return is_kicked ? too_often(values.drive.kick_interval, values) : std::nullopt;
}

Objection snapshots_too_often(const Case& values) {
  const auto& interval = values.output.snapshot_interval;
  return interval ? too_often(*interval, values) : std::nullopt;
}

Objection samples_too_often(const Case& values) {
  const auto& interval = values.measure.sampling_interval;
  return interval ? too_often(*interval, values) : std::nullopt;
}

}  // namespace

std::optional<std::string> wrong_speed(const std::vector<double>& velocities, int dimension) {
  const auto is_slower = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto most = std::max_element(velocities.begin(), velocities.end(), is_slower);
  if (most == velocities.end() || is_right(*most)) return std::nullopt;
  return fmt::format("the fastest sphere, {}, has a velocity of {:g}; {}",
                     (most - velocities.begin()) / dimension, *most, range_text());
}

std::vector<double> flat(const std::vector<std::vector<double>>& rows) {
  std::vector<double> numbers;
  for (const auto& row : rows) numbers.insert(numbers.end(), row.begin(), row.end());
  return numbers;
}

double thermal_speed(const Case& values, const std::vector<double>& positions,
                     const std::vector<double>& velocities) {
  const auto components = static_cast<std::size_t>(values.system.dimension);
  const double across = speed_across(values);
  const double middle = across > 0 ? side_along(values, 1) / 2 : 0;
  double largest = across;  // of what is added up
  long double squares = 0;
  for (std::size_t axis = 0; axis < components; ++axis) {
    std::vector<long double> own;
    for (std::size_t at = axis; at < velocities.size(); at += components) {
      const bool flows = axis == 0 && across > 0;
      own.push_back(velocities[at] -
                    (flows ? values.drive.shear_rate * (positions[at + 1] - middle) : 0));
      largest = std::max(largest, std::abs(velocities[at]));
    }
    const bool is_closed = closed_axis(values) == static_cast<int>(axis);
    const long double sum = std::accumulate(own.begin(), own.end(), 0.0L);
    const long double shared = is_closed ? 0 : sum / static_cast<long double>(own.size());
    for (const long double speed : own) squares += (speed - shared) * (speed - shared);
  }
  const auto speed =
      static_cast<double>(std::sqrt(squares / static_cast<long double>(velocities.size())));
  const double rounding = 4 * rounding_of(Precision::double_precision) * largest;
  return speed > rounding ? speed : 0;
}

std::span<const Rule> speed_rules() {
  constexpr std::string_view fraction = "system.solids_volume_fraction";
  static const std::vector<Rule> rules{
      {{"start.granular_temperature"}, temperature_out_of_range},
      {{"start.velocities", "system.dimension"}, written_speeds_out_of_range},
      {{"drive.shear_rate", "drive.kind", "system.dimension", "system.sides", fraction,
        "system.aspect_ratio", "system.spheres"},
       shear_out_of_range},
      {{"drive.shear_rate", "drive.kind", "system.dimension", "system.sides", fraction,
        "system.aspect_ratio", "system.spheres", "start.granular_temperature", "start.positions",
        "start.velocities", "collision.precision"},
       shear_drowns_temperature},
      {{"gravity.acceleration", "system.dimension", "system.sides", fraction, "system.aspect_ratio",
        "system.spheres"},
       gravity_out_of_range},
      {{"gravity.acceleration", "walls.axis", "start.granular_temperature", "start.positions",
        "start.velocities", "drive.kind", "drive.shear_rate", "system.dimension", "system.sides",
        fraction, "system.aspect_ratio", "system.spheres", "run.time", "collision.precision"},
       fall_drowns_temperature},
      {{"drive.noise_strength", "drive.kind", "drive.kick_interval", "run.time",
        "collision.precision"},
       kicks_out_of_range},
      {{"walls.lower_speed", "walls.axis", "walls.tangential_restitution",
        "start.granular_temperature", "start.positions", "start.velocities", "system.dimension",
        "system.sides", fraction, "system.aspect_ratio", "system.spheres", "collision.precision"},
       lower_wall_out_of_range},
      {{"walls.upper_speed", "walls.axis", "walls.tangential_restitution",
        "start.granular_temperature", "start.positions", "start.velocities", "system.dimension",
        "system.sides", fraction, "system.aspect_ratio", "system.spheres", "collision.precision"},
       upper_wall_out_of_range},
      {{"drive.kick_interval", "drive.kind", "run.time"}, kicks_too_often},
      {{"output.snapshot_interval", "run.time"}, snapshots_too_often},
      {{"measure.sampling_interval", "run.time"}, samples_too_often}};
  return rules;
}

}  // namespace zenosphere::case_format
