#include "io/case_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "io/spelling.hpp"

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

constexpr Condition only_sheared = {"drive.kind",
                                    [](const Case& c) { return c.drive.kind == DriveKind::shear; },
                                    "drive.kind = \"shear\""};
constexpr Condition only_windowed = {
    "output.collision_log",
    [](const Case& c) { return c.output.collision_log == CollisionLog::window; },
    "output.collision_log = \"window\""};

// Sphere indices are 32-bit in the output file and one sphere needs some hundred bytes.
constexpr double most_spheres = 1e8;
// Arrests were met within 2e6 collisions; a longer window than this only delays the verdict.
constexpr double longest_window = 1e8;
// Thirty years at a million collisions a second, and every count up to it is exact in a double.
constexpr double most_collisions = 1e15;
// Close-packed spheres fill pi / (3 sqrt 2) = 0.7404805 of space.
constexpr double densest_packing = 0.74048;

constexpr auto required = Presence::required;
constexpr auto optional = Presence::optional;

constexpr std::array key_table{
    Key{"system", "dimension", required, [](Case& c) -> Slot { return &c.system.dimension; },
        from_to(3, 3, "this version simulates 3 dimensions only"), nullptr, "dimensions of space"},
    Key{"system", "spheres", required, [](Case& c) -> Slot { return &c.system.spheres; },
        from_to(2, most_spheres), nullptr, "number of spheres"},
    Key{"system", "restitution", required, [](Case& c) -> Slot { return &c.system.restitution; },
        from_to(0, 1, "1 is elastic"), nullptr, "normal speed after a collision / before"},
    Key{"system", "solids_volume_fraction", required,
        [](Case& c) -> Slot { return &c.system.solids_volume_fraction; },
        above_to(0, densest_packing, "spheres cannot be packed denser"), nullptr,
        "volume of the spheres / volume of the box"},
    Key{"start", "arrangement", required, [](Case& c) -> Slot { return &c.start.arrangement; }, any,
        nullptr, "how the spheres are placed"},
    Key{"start", "granular_temperature", required,
        [](Case& c) -> Slot { return &c.start.granular_temperature; }, at_least(0), nullptr,
        "variance of each velocity component at the start [diameter^2/time^2]"},
    Key{"start", "seed", optional, [](Case& c) -> Slot { return &c.start.seed; }, at_least(0),
        nullptr, "of the random numbers"},
    Key{"drive", "kind", required, [](Case& c) -> Slot { return &c.drive.kind; }, any, nullptr,
        "what feeds energy to the spheres"},
    Key{"drive", "shear_rate", required, [](Case& c) -> Slot { return &c.drive.shear_rate; },
        at_least(0), &only_sheared, "gradient of the mean velocity [1/time]"},
    Key{"collision", "overlap", optional, [](Case& c) -> Slot { return &c.collision.overlap; }, any,
        nullptr, "what is done with spheres that overlap by rounding while they approach"},
    Key{"collision", "guard", optional, [](Case& c) -> Slot { return &c.collision.guard; },
        at_least(0), nullptr, "the rule guarded lets slower approach pass [diameter^2/time]"},
    Key{"collision", "precision", optional, [](Case& c) -> Slot { return &c.collision.precision; },
        any, nullptr, "of the arithmetic"},
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
        at_least(0), nullptr, "averages start then [time]"},
    Key{"output", "snapshot_interval", optional,
        [](Case& c) -> Slot { return &c.output.snapshot_interval; }, above(0), nullptr,
        "between snapshots [time]"},
    Key{"output", "collision_log", optional,
        [](Case& c) -> Slot { return &c.output.collision_log; }, any, nullptr,
        "which collisions are stored"},
    Key{"output", "log_first", optional, [](Case& c) -> Slot { return &c.output.log_first; },
        from_to(1, most_collisions), &only_windowed, "first collision stored"},
    Key{"output", "log_last", optional, [](Case& c) -> Slot { return &c.output.log_last; },
        from_to(1, most_collisions), &only_windowed, "last collision stored"},
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
  std::vector<std::string_view> names;  // no two tables share one
  for (const Key& key : key_table) {
    names.push_back(key.name);
    if (key.table == table) neighbours.push_back(key.name);
  }
  auto meant = nearest(name, neighbours);
  if (!meant) meant = nearest(name, names);
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
