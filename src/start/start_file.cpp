#include "start/start_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <filesystem>
#include <limits>
#include <mutex>
#include <string>

#include "case/case_box.hpp"
#include "case/case_grains.hpp"
#include "case/case_rules.hpp"
#include "case/case_speeds.hpp"
#include "flow/overlaps.hpp"
#include "model/errors.hpp"
#include "model/offset.hpp"
#include "start/extended_xyz.hpp"
#include "start/lasting_contact.hpp"
#include "start/start_from_output.hpp"
#include "start/start_species.hpp"
#include "storage/output_info.hpp"

namespace zenosphere {
namespace {

[[noreturn]] void reject(const std::string& where, const std::string& text) {
  throw InputError(where + ": " + text);
}

/// `(1.2, -0.5, 2)`: where sphere `i` is.
std::string place_of(const GivenStart& start, std::size_t i) {
  std::string text;
  for (int axis = 0; axis < start.dimension; ++axis) {
    const auto at = i * static_cast<std::size_t>(start.dimension) + static_cast<std::size_t>(axis);
    text += fmt::format("{}{}", text.empty() ? "" : ", ", start.positions[at]);
  }
  return '(' + text + ')';
}

void require_equal_sides(const std::vector<double>& found, const std::vector<double>& sides,
                         const std::string& where) {
  constexpr double equal = 1e-9;  // files in text often have ten digits
  const auto text = [](const std::vector<double>& lengths) {
    std::string joined;
    for (const double length : lengths) {
      joined += fmt::format("{}{}", joined.empty() ? "" : " x ", length);
    }
    return joined;
  };
  for (std::size_t axis = 0; axis < found.size(); ++axis) {
    if (std::abs(found[axis] - sides[axis]) <= equal * sides[axis]) continue;
    reject(where, fmt::format("has a box of {} diameters (that of the case is {}); make them equal "
                              "with system.sides",
                              text(found), text(sides)));
  }
}

/// What a file tells of its spheres is what the case says of them.
void require_equal_grains(const Grains<double>& found, const Grains<double>& wanted,
                          const std::string& where) {
  constexpr double equal = 1e-9;  // files in text often have ten digits
  const auto compare = [&](const char* what, bool is_told, std::size_t count, const auto& of) {
    for (std::size_t k = 0; is_told && k < count; ++k) {
      const auto i = static_cast<std::int32_t>(k);
      if (std::abs(of(found, i) - of(wanted, i)) <= equal * of(wanted, i)) continue;
      reject(where, fmt::format("sphere {} has the {} {:.10g} (in the case it has {:.10g}); give "
                                "the file in the units of the case, and the case its species",
                                i, what, of(found, i), of(wanted, i)));
    }
  };
  const std::size_t spheres = std::max(found.diameters.size(), found.masses.size());
  compare("diameter", !found.diameters.empty(), spheres,
          [](const auto& grains, std::int32_t i) { return grains.diameter(i); });
  compare("mass", !found.masses.empty(), spheres,
          [](const auto& grains, std::int32_t i) { return grains.mass(i); });
}

/// The offset of the images reduced to half a side; none between walls along x or y.
void reduce_offset(const Case& values, GivenStart& start, const std::string& file) {
  if (!std::isfinite(start.offset)) {
    reject(file, fmt::format("its box has an offset of {}; it may be damaged", start.offset));
  }
  start.offset = start.dimension > 1 ? reduced_offset(start.offset, start.sides[0]) : 0.0;
  const auto closed = closed_axis(values);
  if (!closed || *closed > 1) return;
  if (std::abs(start.offset) > touching) {
    reject(file, fmt::format("its images are displaced along x by {} diameters (the case has "
                             "[walls] along {}); take the walls out, or start from an upright box",
                             start.offset, axis_letter(*closed)));
  }
  start.offset = 0;
}

/// The boundaries that the file tells, if it does, are those of the case.
void require_equal_boundaries(const Case& values, const XyzFrame& frame, const std::string& file) {
  for (int axis = 0; frame.is_periodic && axis < values.system.dimension; ++axis) {
    const bool is_periodic = (*frame.is_periodic)[static_cast<std::size_t>(axis)];
    const bool is_closed = closed_axis(values) == axis;
    if (is_periodic != is_closed) continue;
    reject(file, fmt::format("pbc has {} along {} (the case {} there); make them agree",
                             is_periodic ? 'T' : 'F', axis_letter(axis),
                             is_closed ? "has [walls]" : "is periodic"));
  }
}

GivenStart start_from_text(const Case& values, const std::string& file) {
  const int dimension = values.system.dimension;
  XyzFrame frame = read_frame(file, dimension, values.system.spheres, values.start.snapshot);
  if (!values.start.granular_temperature) {
    if (frame.velocities.empty()) {
      reject(file, "has no velocities (a column velo:R:3); add them or start.granular_temperature");
    }
    if (frame.needs_masses) {
      reject(file,
             "has momenta of spheres whose mass it does not tell (must be 1); add a column "
             "masses:R:1, or give velo:R:3");
    }
  }
  require_equal_boundaries(values, frame, file);
  require_equal_kinds(frame.kinds, values, file);
  return {dimension,
          std::move(frame.positions),
          std::move(frame.velocities),
          std::move(frame.sides),
          frame.offset,
          {std::move(frame.diameters), std::move(frame.masses)},
          std::move(frame.spins)};
}

/// Every centre a radius away from walls at least, and elsewhere so near that it has its digits.
void require_within_reach(const Case& values, const GivenStart& start, const std::string& where) {
  const auto components = static_cast<std::size_t>(start.dimension);
  const auto closed = closed_axis(values);
  for (std::size_t at = 0; at < start.positions.size(); ++at) {
    const int axis = static_cast<int>(at % components);
    const double position = start.positions[at];
    const double side = start.sides[at % components];
    const std::size_t i = at / components;
    if (closed != axis) {
      if (std::abs(position) <= largest_side) continue;
      reject(where, fmt::format("sphere {} at {} is too far away to be wrapped into the box (|{}| "
                                "<= {}); move it",
                                i, place_of(start, i), axis_letter(axis), largest_side));
    }
    const double radius = start.grains.radius(static_cast<std::int32_t>(i));
    if (position >= radius - touching && position <= side - radius + touching) continue;
    const bool is_outside = !(position >= 0 && position < side);
    reject(where, fmt::format("sphere {} at {} is {} ({} <= {} <= {}); move it", i,
                              place_of(start, i), is_outside ? "behind a wall" : "in a wall",
                              radius, axis_letter(axis), side - radius));
  }
}

/// Puts every centre in [0, L) along the periodic axes: the image of it that is there, which flows
/// with the profile at its new place.
void wrap(const Case& values, GivenStart& start) {
  const auto components = static_cast<std::size_t>(start.dimension);
  const double shear_rate = values.drive.kind == DriveKind::shear ? values.drive.shear_rate : 0;
  for (std::size_t end = start.positions.size(); end > 0;
       --end) {  // y before x, which it displaces
    const std::size_t at = end - 1;
    const std::size_t axis = at % components;
    double& position = start.positions[at];
    const double side = start.sides[axis];
    if (closed_axis(values) == static_cast<int>(axis) || (position >= 0 && position < side)) {
      continue;
    }
    const double periods = std::floor(position / side);
    position = std::max(position - side * periods, 0.0);
    if (!(position < side)) position = 0;  // a tiny distance below the lower face
    if (axis != 1) continue;
    start.positions[at - 1] -= periods * start.offset;
    if (!start.velocities.empty()) start.velocities[at - 1] -= shear_rate * side * periods;
  }
}

void require_no_overlap(const Case& values, const GivenStart& start, const std::string& where) {
  const Overlap deepest = deepest_overlap(
      {start.positions, start.sides, start.offset, closed_axis(values), start.grains.diameters});
  // In a long box rounding leaves more: half an ulp for each coordinate and for the difference.
  const double longest = *std::max_element(start.sides.begin(), start.sides.end());
  const double rounding = 2 * std::numeric_limits<double>::epsilon() * longest;
  if (deepest.depth <= std::max(touching, rounding)) return;
  const double reach = start.grains.radius(static_cast<std::int32_t>(deepest.i)) +
                       start.grains.radius(static_cast<std::int32_t>(deepest.j));
  reject(where,
         fmt::format("spheres {} and {} overlap (distance {:.13g} diameters{}); move them apart",
                     deepest.i, deepest.j, reach - deepest.depth,
                     reach == 1 ? "" : fmt::format(", they touch at {:g}", reach)));
}

/// Written velocities have been judged with the case.
void require_motion(const Case& values, const GivenStart& start, const std::string& where) {
  const auto rests = [](double component) { return component == 0; };
  if (values.start.granular_temperature || case_format::is_driven(values)) return;
  if (!std::all_of(start.velocities.begin(), start.velocities.end(), rests)) return;
  reject(where,
         "all velocities are 0 (nothing would ever move); add start.granular_temperature or "
         "drive the spheres");
}

/// What the drive leaves of the digits of velocities that were read; those that are written have
/// been judged with the case.
void require_digits(const Case& values, const GivenStart& start, const std::string& where) {
  if (values.start.arrangement != Arrangement::file || start.velocities.empty()) return;
  const double speed = case_format::thermal_speed(values, start.positions, start.velocities);
  Case as_drawn = values;
  as_drawn.start.granular_temperature = speed * speed;
  for (const auto& rule : case_format::speed_rules()) {
    if (rule.keys.front() == "start.granular_temperature") continue;
    if (const auto objection = rule.objection(as_drawn)) {
      reject(where, fmt::format("its velocities are not for {} {}", rule.keys.front(), *objection));
    }
  }
}

/// No sphere that is held on a wall without a speed.
void require_no_lasting_contact(const Case& values, const GivenStart& start,
                                const std::string& where) {
  const auto held = lasting_contact(values, start);
  if (!held) return;
  const std::string place = fmt::format("{} at {}", held->sphere, place_of(start, held->sphere));
  reject(where,
         fmt::format("sphere {} rests on a wall, {} (contacts of hard spheres are instants: "
                     "the clock would stand at 0); lift it, or give it {}",
                     place, held->is_pushed ? "which begins to push it" : "where gravity holds it",
                     held->is_pushed ? "a walls.resting_flight" : "a speed away from the wall"));
}

}  // namespace

GivenStart given_start(const Case& values) {
  const bool is_written = values.start.arrangement == Arrangement::given;
  assert(is_written || values.start.arrangement == Arrangement::file);
  const std::string& file = values.start.file;
  const std::string where = is_written ? "start.positions" : file;
  GivenStart start;
  if (is_written) {
    using case_format::flat;
    start = {values.system.dimension,
             flat(values.start.positions),
             flat(values.start.velocities),
             {},
             0};
  } else {
    // Such a file is read in a copy of the process first.
    const std::lock_guard lock(one_start_at_a_time());
    start = is_hdf5_file(file) ? start_from_output(values, file) : start_from_text(values, file);
    require_equal_sides(start.sides, box_sides(values), where);
  }
  start.sides = box_sides(values);
  if (!is_written) require_equal_grains(start.grains, grains_of(values), where);
  start.grains = grains_of(values);
  reduce_offset(values, start, where);
  if (values.start.granular_temperature) {
    start.velocities.clear();
    start.spins.clear();
  }
  const auto is_finite = [](double number) { return std::isfinite(number); };
  if (!std::all_of(start.velocities.begin(), start.velocities.end(), is_finite) ||
      !std::all_of(start.spins.begin(), start.spins.end(), is_finite)) {
    reject(where, "has velocities that are not finite numbers; give others");
  }
  if (const auto wrong = case_format::wrong_speed(start.velocities, start.dimension)) {
    reject(where, *wrong + "; choose another unit of time");
  }
  require_within_reach(values, start, where);
  wrap(values, start);
  require_no_overlap(values, start, where);
  require_motion(values, start, where);
  require_digits(values, start, where);
  require_no_lasting_contact(values, start, where);
  return start;
}

}  // namespace zenosphere
