#include "case/case_rules.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "case/case_box.hpp"
#include "text/counted.hpp"

namespace zenosphere::case_format {
namespace {

using Objection = std::optional<std::string>;

bool is_zero(double number) { return number == 0; }

Objection shear_on_a_line(const Case& values) {
  const bool sheared = values.drive.kind == DriveKind::shear;
  if (!sheared || values.system.dimension > 1) return std::nullopt;
  return "(needs a flow and a gradient direction, system.dimension = 1); use 2 or 3 dimensions";
}

Objection shear_between_walls(const Case& values) {
  if (values.drive.kind != DriveKind::shear || !values.walls.axis) return std::nullopt;
  if (values.walls.axis == Axis::y) {
    return "(its gradient direction y ends at walls); shear by moving walls: walls.lower_speed and "
           "walls.upper_speed with drive.kind = \"none\"";
  }
  return "(not together with [walls] in this version); remove one of the two";
}

Objection gravity_along_the_gradient(const Case& values) {
  const auto& acceleration = values.gravity.acceleration;
  const bool falls = acceleration.size() > 1 && acceleration[1] != 0;
  if (values.drive.kind != DriveKind::shear || !falls) return std::nullopt;
  return "(has a component along y, the gradient direction of the shear, across whose sliding "
         "boundary spheres would fall for ever); let it point along x or z";
}

Objection gravity_has_other_dimension(const Case& values) {
  const auto components = values.gravity.acceleration.size();
  if (components == 0 || components == static_cast<std::size_t>(values.system.dimension)) {
    return std::nullopt;
  }
  return fmt::format("(number of components = {}, system.dimension = {}); make them equal",
                     components, values.system.dimension);
}

Objection rotation_on_a_line(const Case& values) {
  if (values.collision.rotation_angle == 0 || values.system.dimension > 1) return std::nullopt;
  return "(nothing turns on a line, system.dimension = 1); remove it or use 2 or 3 dimensions";
}

/// What is wrong with the shape of positions or velocities written in the case.
Objection wrong_shape(const std::vector<std::vector<double>>& rows, const Case& values) {
  if (values.start.arrangement != Arrangement::given || rows.empty()) return std::nullopt;
  const auto components = static_cast<std::size_t>(values.system.dimension);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].size() == components) continue;
    return fmt::format("(sphere {} has {} components, system.dimension = {}); make them equal", i,
                       rows[i].size(), components);
  }
  if (rows.size() == static_cast<std::size_t>(values.system.spheres)) return std::nullopt;
  return fmt::format("(has {}, system.spheres = {}); make them equal",
                     counted(static_cast<std::int64_t>(rows.size()), "sphere"),
                     values.system.spheres);
}

Objection positions_have_wrong_shape(const Case& values) {
  return wrong_shape(values.start.positions, values);
}

Objection velocities_have_wrong_shape(const Case& values) {
  return wrong_shape(values.start.velocities, values);
}

Objection nothing_moves(const Case& values) {
  const auto& temperature = values.start.granular_temperature;
  if (!temperature || *temperature > 0 || is_driven(values)) return std::nullopt;
  return "(nothing would ever move); use a value above 0, or drive the spheres";
}

Objection nothing_moves_as_given(const Case& values) {
  const auto& start = values.start;
  const bool is_read = start.arrangement == Arrangement::given && !start.velocities.empty();
  if (!is_read || is_driven(values)) return std::nullopt;
  const auto rests = [](const auto& row) { return std::all_of(row.begin(), row.end(), is_zero); };
  if (!std::all_of(start.velocities.begin(), start.velocities.end(), rests)) return std::nullopt;
  return "(nothing would ever move); use a velocity other than 0, or drive the spheres";
}

Objection log_ends_before_it_begins(const Case& values) {
  const auto& output = values.output;
  if (!output.log_last || *output.log_last >= output.log_first) return std::nullopt;
  return fmt::format("(must be >= output.log_first = {})", output.log_first);
}

/// The box, then what is in it, then what is done to it, then how fast all that is.
std::vector<Rule> all_rules() {
  std::vector<Rule> rules(box_rules().begin(), box_rules().end());
  const std::vector<Rule> others{
      {{"start.positions", "start.arrangement", "system.dimension", "system.spheres"},
       positions_have_wrong_shape},
      {{"start.velocities", "start.arrangement", "system.dimension", "system.spheres"},
       velocities_have_wrong_shape},
      {{"drive.kind", "system.dimension"}, shear_on_a_line},
      {{"drive.kind", "walls.axis"}, shear_between_walls},
      {{"gravity.acceleration", "drive.kind"}, gravity_along_the_gradient},
      {{"gravity.acceleration", "system.dimension"}, gravity_has_other_dimension},
      {{"collision.rotation_angle", "system.dimension"}, rotation_on_a_line},
      {{"start.granular_temperature", "drive.kind", "drive.shear_rate", "gravity.acceleration",
        "walls.lower_speed", "walls.upper_speed", "walls.motion"},
       nothing_moves},
      {{"start.velocities", "start.arrangement", "start.granular_temperature", "drive.kind",
        "drive.shear_rate", "gravity.acceleration", "walls.lower_speed", "walls.upper_speed",
        "walls.motion"},
       nothing_moves_as_given},
      {{"output.log_last", "output.log_first"}, log_ends_before_it_begins}};
  rules.insert(rules.end(), others.begin(), others.end());
  rules.insert(rules.end(), wall_rules().begin(), wall_rules().end());
  rules.insert(rules.end(), grain_rules().begin(), grain_rules().end());
  rules.insert(rules.end(), speed_rules().begin(), speed_rules().end());
  return rules;
}

bool always(const Case&) { return true; }

bool draws_velocities(const Case& values) {
  const auto arrangement = values.start.arrangement;
  return arrangement == Arrangement::fcc || arrangement == Arrangement::random;
}

bool is_written(const Case& values) { return values.start.arrangement == Arrangement::given; }

constexpr std::array all_choices{
    Choice{{"system.solids_volume_fraction", "system.sides"},
           "",
           always,
           true,
           "the box needs a size"},
    Choice{{"start.granular_temperature", ""},
           "start.arrangement",
           draws_velocities,
           false,
           "physics has no default"},
    Choice{{"start.granular_temperature", "start.velocities"},
           "start.arrangement",
           is_written,
           true,
           "the spheres need velocities"},
    Choice{{"run.collisions", "run.time"}, "", always, false, "a run needs an end"}};

}  // namespace

std::span<const Rule> rules() {
  static const std::vector<Rule> rules = all_rules();
  return rules;
}

std::span<const Choice> choices() { return all_choices; }

bool is_driven(const Case& values) {
  const auto kind = values.drive.kind;
  const auto& acceleration = values.gravity.acceleration;
  const bool falls = !std::all_of(acceleration.begin(), acceleration.end(), is_zero);
  const bool walls_move = values.walls.lower_speed != 0 || values.walls.upper_speed != 0 ||
                          values.walls.motion.has_value();
  return (kind == DriveKind::shear && values.drive.shear_rate > 0) || kind == DriveKind::random ||
         falls || walls_move;
}

}  // namespace zenosphere::case_format
