#include "io/start_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <filesystem>
#include <mutex>
#include <string>

#include "io/case_box.hpp"
#include "io/case_rules.hpp"
#include "io/extended_xyz.hpp"
#include "io/output_reader.hpp"
#include "io/start_overlap.hpp"
#include "model/errors.hpp"

namespace zenosphere {
namespace {

[[noreturn]] void reject(const std::string& where, const std::string& text) {
  throw InputError(where + ": " + text);
}

std::vector<double> flat(const std::vector<std::vector<double>>& rows) {
  std::vector<double> numbers;
  for (const auto& row : rows) numbers.insert(numbers.end(), row.begin(), row.end());
  return numbers;
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

GivenStart start_from_output(const Case& values, const std::string& file) {
  const int dimension = values.system.dimension;
  LastSnapshot last = read_last_snapshot(file, dimension, values.system.spheres);
  std::vector<double> sides;
  for (int row = 0; row < dimension; ++row) {
    for (int column = 0; column < dimension; ++column) {
      const double edge = last.box_edges[static_cast<std::size_t>(row * dimension + column)];
      if (row == column) sides.push_back(edge);
      if (row == column || std::abs(edge) <= touching) continue;
      reject(file, fmt::format("its box is sheared by an offset of {} diameters (a run starts from "
                               "an upright box, whose images lie elsewhere); take the end of a run "
                               "whose strain x height is a whole number of lengths",
                               edge));
    }
  }
  return {dimension, std::move(last.positions), std::move(last.velocities), std::move(sides)};
}

GivenStart start_from_text(const Case& values, const std::string& file) {
  const int dimension = values.system.dimension;
  XyzFrame frame = read_last_frame(file, dimension, values.system.spheres);
  if (frame.velocities.empty() && !values.start.granular_temperature) {
    reject(file, "has no velocities (a column velo:R:3); add them or start.granular_temperature");
  }
  return {dimension, std::move(frame.positions), std::move(frame.velocities),
          std::move(frame.sides)};
}

/// Every centre in [0, L), between walls in [1/2, L - 1/2].
void require_in_box(const Case& values, const GivenStart& start, const std::string& where) {
  const auto components = static_cast<std::size_t>(start.dimension);
  const auto closed = closed_axis(values);
  for (std::size_t at = 0; at < start.positions.size(); ++at) {
    const int axis = static_cast<int>(at % components);
    const char letter = axis_letter(axis);
    const double position = start.positions[at];
    const double side = start.sides[at % components];
    const std::size_t i = at / components;
    if (!(position >= 0 && position < side)) {
      reject(where, fmt::format("sphere {} at {} is outside the box (0 <= {} < {}); move it", i,
                                place_of(start, i), letter, side));
    }
    if (closed != axis) continue;
    if (position >= 0.5 - touching && position <= side - 0.5 + touching) continue;
    reject(where, fmt::format("sphere {} at {} is in a wall (0.5 <= {} <= {}); move it", i,
                              place_of(start, i), letter, side - 0.5));
  }
}

void require_no_overlap(const Case& values, const GivenStart& start, const std::string& where) {
  const auto pair = first_overlap(start.positions, start.sides, closed_axis(values));
  if (!pair) return;
  reject(where,
         fmt::format("spheres {} and {} overlap (distance {:.13g} diameters); move them apart",
                     pair->i, pair->j, pair->distance));
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

}  // namespace

GivenStart given_start(const Case& values) {
  const bool is_written = values.start.arrangement == Arrangement::given;
  assert(is_written || values.start.arrangement == Arrangement::file);
  const std::string& file = values.start.file;
  const std::string where = is_written ? "start.positions" : file;
  GivenStart start;
  if (is_written) {
    start = {
        values.system.dimension, flat(values.start.positions), flat(values.start.velocities), {}};
  } else {
    // HDF5 is not made for threads, and such a file is read in a copy of the process first.
    static std::mutex one_at_a_time;
    const std::lock_guard lock(one_at_a_time);
    start = is_hdf5_file(file) ? start_from_output(values, file) : start_from_text(values, file);
    require_equal_sides(start.sides, box_sides(values), where);
  }
  start.sides = box_sides(values);
  if (values.start.granular_temperature) start.velocities.clear();
  const auto is_finite = [](double number) { return std::isfinite(number); };
  if (!std::all_of(start.velocities.begin(), start.velocities.end(), is_finite)) {
    reject(where, "has velocities that are not finite numbers; give others");
  }
  require_in_box(values, start, where);
  require_no_overlap(values, start, where);
  require_motion(values, start, where);
  return start;
}

}  // namespace zenosphere
