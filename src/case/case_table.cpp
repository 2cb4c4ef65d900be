#include "case/case_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "case/case_box.hpp"
#include "case/case_conditions.hpp"
#include "model/limits.hpp"
#include "text/spelling.hpp"

namespace zenosphere::case_format {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

constexpr Range at_least(double low) { return {low, unbounded, true, ""}; }
constexpr Range above(double low) { return {low, unbounded, false, ""}; }
constexpr Range from_to(double low, double high, std::string_view note = "") {
  return {low, high, true, note};
}
constexpr Range above_to(double low, double high, std::string_view note = "") {
  return {low, high, false, note};
}
constexpr Range any = from_to(-unbounded, unbounded);

// Sphere indices are 32-bit in the output file and one sphere needs some hundred bytes.
// Arrests were met within 2e6 collisions; a longer window than this only delays the verdict.
constexpr double longest_window = 1e8;
// Thirty years at a million collisions a second, and every count up to it is exact in a double.
constexpr double most_collisions = 1e15;
// Beyond every run, and far below the time at which a sphere that never met has met.
constexpr double longest_contact = 1e100;
// Every collision faster than 1e-100 is wholly inelastic then.
constexpr double most_viscoelastic = 1e100;
// Beyond every collision, and four times it is a number.
constexpr double most_loss = 1e300;
// Every contact sticks then; more is "unbounded".
constexpr double most_friction = 1e100;
// A right angle: a pair may still recede then, whatever its velocity.
constexpr double widest_rotation = 1.57;

// Far above the rounding of places, of which the wall has to be clear.
constexpr double least_amplitude = 1e-9;
// A sphere that rests is let go a thousand times in a period at least: its height is 1e-6 of the
// way of the wall then.
constexpr double longest_resting_flight = 1e-3;

constexpr auto required = Presence::required;
constexpr auto optional = Presence::optional;
constexpr auto with_table = Presence::with_table;

constexpr std::array key_table{
    Key{"system", "dimension", required, [](Case& c) -> Slot { return &c.system.dimension; },
        from_to(1, 3), nullptr, "dimensions of space"},
    Key{"system", "spheres", required, [](Case& c) -> Slot { return &c.system.spheres; },
        from_to(1, static_cast<double>(most_spheres)), nullptr, "number of spheres"},
    Key{"system", "restitution", required, [](Case& c) -> Slot { return &c.system.restitution; },
        from_to(0, 1, "1 is elastic"), &only_constant, "normal speed after a collision / before"},
    Key{"system", "solids_volume_fraction", optional,
        [](Case& c) -> Slot { return &c.system.solids_volume_fraction; }, above_to(0, 1),
        &only_without_sides, "volume of the spheres / volume of the box"},
    Key{"system", "sides", optional, [](Case& c) -> Slot { return &c.system.sides; },
        above_to(1, largest_side), nullptr, "of the box [diameters]"},
    Key{"system", "aspect_ratio", optional, [](Case& c) -> Slot { return &c.system.aspect_ratio; },
        above_to(0.01, 100, "for others give system.sides"), &only_in_a_proportion,
        "side of the box along x / each other side"},
    Key{"start", "arrangement", required, [](Case& c) -> Slot { return &c.start.arrangement; }, any,
        nullptr, "how the spheres are placed"},
    Key{"start", "granular_temperature", optional,
        [](Case& c) -> Slot { return &c.start.granular_temperature; }, at_least(0), nullptr,
        "variance of each velocity component at the start [diameter^2/time^2]"},
    Key{"start", "seed", optional, [](Case& c) -> Slot { return &c.start.seed; }, at_least(0),
        nullptr, "of the random numbers"},
    Key{"start", "positions", required, [](Case& c) -> Slot { return &c.start.positions; }, any,
        &only_given, "one sphere a line [diameters]"},
    Key{"start", "velocities", optional, [](Case& c) -> Slot { return &c.start.velocities; }, any,
        &only_given, "one sphere a line, in the laboratory [diameters/time]"},
    Key{"start", "file", required, [](Case& c) -> Slot { return &c.start.file; }, any,
        &only_from_file, "extended XYZ or an output file: its last state"},
    Key{"start", "snapshot", optional, [](Case& c) -> Slot { return &c.start.snapshot; },
        at_least(0), &only_from_file, "of the file, from 0, instead of the last"},
    Key{"drive", "kind", required, [](Case& c) -> Slot { return &c.drive.kind; }, any, nullptr,
        "what feeds energy to the spheres"},
    Key{"drive", "shear_rate", required, [](Case& c) -> Slot { return &c.drive.shear_rate; },
        at_least(0), &only_sheared, "gradient of the mean velocity [1/time]"},
    Key{"drive", "noise_strength", required,
        [](Case& c) -> Slot { return &c.drive.noise_strength; }, above(0), &only_kicked,
        "variance of each velocity component gained per time [diameter^2/time^3]"},
    Key{"drive", "kick_interval", required, [](Case& c) -> Slot { return &c.drive.kick_interval; },
        above(0), &only_kicked, "time between kicks [time]"},
    Key{"walls", "axis", with_table, [](Case& c) -> Slot { return &c.walls.axis; }, any, nullptr,
        "normal of the two walls that replace the periodic boundary"},
    Key{"walls", "restitution", with_table, [](Case& c) -> Slot { return &c.walls.restitution; },
        from_to(0, 1, "1 is elastic"), &only_walled, "normal speed after a wall / before"},
    Key{"walls", "tangential_restitution", optional,
        [](Case& c) -> Slot { return &c.walls.tangential_restitution; },
        from_to(-1, 1, "-1 is smooth"), &only_touched,
        "- tangential speed against the wall after / before"},
    Key{"walls", "friction", optional, [](Case& c) -> Slot { return &c.walls.friction; },
        from_to(0, most_friction, "or \"unbounded\""), &only_touched,
        "tangential impulse of a rough sphere that slides on a wall / normal impulse"},
    Key{"walls", "lower_speed", optional, [](Case& c) -> Slot { return &c.walls.lower_speed; }, any,
        &only_sliding, "of the lower wall, along x [diameters/time]"},
    Key{"walls", "upper_speed", optional, [](Case& c) -> Slot { return &c.walls.upper_speed; }, any,
        &only_sliding, "of the upper wall, along x [diameters/time]"},
    Key{"walls", "motion", optional, [](Case& c) -> Slot { return &c.walls.motion; }, any,
        &only_walled, "of the lower wall along the axis, from its lowest place, 0, and back"},
    Key{"walls", "amplitude", required, [](Case& c) -> Slot { return &c.walls.amplitude; },
        from_to(least_amplitude, largest_side), &only_oscillating,
        "of that motion: half the way from the lowest to the highest place [diameters]"},
    Key{"walls", "frequency", required, [](Case& c) -> Slot { return &c.walls.frequency; },
        above(0), &only_oscillating, "of that motion: periods in a time unit [1/time]"},
    Key{"walls", "resting_flight", optional,
        [](Case& c) -> Slot { return &c.walls.resting_flight; },
        from_to(0, longest_resting_flight, "0 is off"), &only_oscillating,
        "a sphere that would be back on that wall sooner is let go for so long [periods]"},
    Key{"walls", "lower_temperature", optional,
        [](Case& c) -> Slot { return &c.walls.lower_temperature; }, above(0), &only_walled,
        "makes the lower wall a thermal one [mass diameter^2/time^2]"},
    Key{"walls", "upper_temperature", optional,
        [](Case& c) -> Slot { return &c.walls.upper_temperature; }, above(0), &only_walled,
        "makes the upper wall a thermal one [mass diameter^2/time^2]"},
    Key{"gravity", "acceleration", with_table,
        [](Case& c) -> Slot { return &c.gravity.acceleration; }, any, nullptr,
        "of every sphere [diameters/time^2]"},
    Key{"collision", "overlap", optional, [](Case& c) -> Slot { return &c.collision.overlap; }, any,
        nullptr, "what is done with spheres that overlap by rounding while they approach"},
    Key{"collision", "guard", optional, [](Case& c) -> Slot { return &c.collision.guard; },
        at_least(0), nullptr, "the rule guarded lets slower approach pass [diameter^2/time]"},
    Key{"collision", "precision", optional, [](Case& c) -> Slot { return &c.collision.precision; },
        any, nullptr, "of the arithmetic"},
    Key{"collision", "restitution_law", optional,
        [](Case& c) -> Slot { return &c.collision.restitution_law; }, any, nullptr,
        "how the restitution depends on the speed"},
    Key{"collision", "viscoelastic_constant", required,
        [](Case& c) -> Slot { return &c.collision.viscoelastic_constant; },
        above_to(0, most_viscoelastic), &only_viscoelastic,
        "A in e = 1 - C1 A v^(1/5) + ... [(time/diameter)^(1/5)]"},
    Key{"collision", "energy_loss", required,
        [](Case& c) -> Slot { return &c.collision.energy_loss; }, above_to(0, most_loss),
        &only_fixed_loss,
        "of each collision with more kinetic energy along its normal [mass diameter^2/time^2]"},
    Key{"collision", "slow_restitution", required,
        [](Case& c) -> Slot { return &c.collision.slow_restitution; },
        from_to(0, 1, "1 is elastic"), &only_two_valued,
        "normal speed after a collision / before, below the threshold"},
    Key{"collision", "fast_restitution", required,
        [](Case& c) -> Slot { return &c.collision.fast_restitution; },
        from_to(0, 1, "1 is elastic"), &only_two_valued, "the same from the threshold on"},
    Key{"collision", "threshold_speed", required,
        [](Case& c) -> Slot { return &c.collision.threshold_speed; }, above(0), &only_two_valued,
        "closing speed along the normal at which the restitution changes [diameters/time]"},
    Key{"collision", "contact_duration", optional,
        [](Case& c) -> Slot { return &c.collision.contact_duration; },
        from_to(0, longest_contact, "0 is off"), nullptr,
        "a sphere that collides again within it does so elastically; 0 is off [time]"},
    Key{"collision", "rotation_angle", optional,
        [](Case& c) -> Slot { return &c.collision.rotation_angle; },
        from_to(0, widest_rotation, "0 is off"), nullptr,
        "most that a collision turns the relative velocity, at random [radians]"},
    Key{"collision", "tangential_restitution", optional,
        [](Case& c) -> Slot { return &c.collision.tangential_restitution; },
        from_to(-1, 1, "-1 is smooth"), &only_turning,
        "- tangential speed of the surfaces after a sticking contact / before"},
    Key{"collision", "friction", optional, [](Case& c) -> Slot { return &c.collision.friction; },
        from_to(0, most_friction, "or \"unbounded\""), &only_turning,
        "tangential impulse of a sliding contact / normal impulse"},
    Key{"collision", "reduced_moment_of_inertia", optional,
        [](Case& c) -> Slot { return &c.collision.reduced_moment_of_inertia; },
        above_to(0, 1, "1 is a ring"), &only_turning,
        "4 moment of inertia / (mass diameter^2) of rough spheres"},
    Key{"polydispersity", "distribution", with_table,
        [](Case& c) -> Slot { return &c.polydispersity.distribution; }, any, nullptr,
        "of the diameters of a species"},
    Key{"polydispersity", "spread", with_table,
        [](Case& c) -> Slot { return &c.polydispersity.spread; }, from_to(0, 1), &only_spread,
        "standard deviation / mean of the diameter"},
    Key{"collapse", "gap_threshold", optional,
        [](Case& c) -> Slot { return &c.collapse.gap_threshold; }, above(0), nullptr,
        "a gap up to this meets the separation criterion [diameters]"},
    Key{"collapse", "window", optional, [](Case& c) -> Slot { return &c.collapse.window; },
        from_to(2, longest_window), nullptr, "length of the arrest criterion [collisions]"},
    Key{"collapse", "stop_when_collapsed", optional,
        [](Case& c) -> Slot { return &c.collapse.stop_when_collapsed; }, any, nullptr,
        "the arrest criterion ends the run"},
    Key{"run", "collisions", optional, [](Case& c) -> Slot { return &c.run.collisions; },
        from_to(0, most_collisions), nullptr, "the run ends after so many"},
    Key{"run", "time", optional, [](Case& c) -> Slot { return &c.run.time; }, at_least(0), nullptr,
        "the run ends then [time]"},
    Key{"measure", "after_time", optional, [](Case& c) -> Slot { return &c.measure.after_time; },
        at_least(0), nullptr,
        "averages start then [time], or where the steady state is found to begin: \"auto\""},
    Key{"measure", "interval", optional, [](Case& c) -> Slot { return &c.measure.interval; },
        above(0), nullptr, "between the values of the time series [time]"},
    Key{"measure", "sampling_interval", optional,
        [](Case& c) -> Slot { return &c.measure.sampling_interval; }, above(0), nullptr,
        "between samples of structure and velocities, accumulated in the run [time]"},
    Key{"output", "snapshot_interval", optional,
        [](Case& c) -> Slot { return &c.output.snapshot_interval; }, above(0), nullptr,
        "between snapshots [time]"},
    Key{"output", "snapshot_spacing", optional,
        [](Case& c) -> Slot { return &c.output.snapshot_spacing; }, any, &only_with_snapshots,
        "how snapshots follow each other; log: ten in each decade of time"},
    Key{"output", "collision_log", optional,
        [](Case& c) -> Slot { return &c.output.collision_log; }, any, nullptr,
        "which collisions are stored"},
    Key{"output", "log_first", optional, [](Case& c) -> Slot { return &c.output.log_first; },
        from_to(1, most_collisions), &only_windowed, "first collision stored"},
    Key{"output", "log_last", optional, [](Case& c) -> Slot { return &c.output.log_last; },
        from_to(1, most_collisions), &only_windowed, "last collision stored"},
    Key{"output", "checkpoint_seconds", optional,
        [](Case& c) -> Slot { return &c.output.checkpoint_seconds; }, above(0), nullptr,
        "wall time between checkpoints, at least [s]"},
    Key{"output", "checkpoint_collisions", optional,
        [](Case& c) -> Slot { return &c.output.checkpoint_collisions; },
        from_to(1, most_collisions), nullptr, "a checkpoint after every so many"},
};

}  // namespace

std::string Range::text() const {
  const std::string note_text = note.empty() ? "" : fmt::format("; {}", note);
  if (low == high) return fmt::format("must be {}{}", low, note_text);
  if (high == unbounded) return fmt::format("must be {} {}", low_belongs ? ">=" : ">", low);
  return fmt::format("must be in {}{}, {}]{}", low_belongs ? "[" : "(", low, high, note_text);
}

std::span<const Key> keys() { return key_table; }

const Key* key_named(std::string_view table, std::string_view name) {
  const auto is_it = [&](const Key& key) { return key.table == table && key.name == name; };
  const auto found = std::find_if(key_table.begin(), key_table.end(), is_it);
  return found == key_table.end() ? nullptr : &*found;
}

bool is_table(std::string_view name) {
  const auto is_in_it = [&](const Key& key) { return key.table == name; };
  return std::any_of(key_table.begin(), key_table.end(), is_in_it);
}

const Key* nearest_key(std::string_view table, std::string_view name) {
  std::vector<std::string_view> neighbours;
  std::vector<std::string_view> names;
  for (const Key& key : key_table) {
    names.push_back(key.name);
    if (key.table == table) neighbours.push_back(key.name);
  }
  if (const auto neighbour = nearest(name, neighbours)) return key_named(table, *neighbour);
  const auto meant = nearest(name, names);
  const auto is_it = [&](const Key& key) { return key.name == meant; };
  return meant ? &*std::find_if(key_table.begin(), key_table.end(), is_it) : nullptr;
}

std::optional<std::string_view> nearest_table(std::string_view name) {
  std::vector<std::string_view> tables;
  tables.reserve(key_table.size());
  for (const Key& key : key_table) tables.push_back(key.table);
  return nearest(name, tables);
}

}  // namespace zenosphere::case_format
