#include "start/extended_xyz.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include "model/limits.hpp"
#include "start/xyz_header.hpp"
#include "start/xyz_lines.hpp"
#include "text/counted.hpp"

namespace zenosphere {
namespace {

using xyz::Lines;

/// The number of spheres that the first line of a frame tells.
std::int64_t spheres_in(std::string_view line, const Lines& lines) {
  const std::string_view word = xyz::next_word(line);
  const auto spheres = xyz::number_in<std::int64_t>(word);
  if (!spheres || !xyz::next_word(line).empty()) {
    lines.reject("found no number of spheres (extended XYZ begins each frame with it)");
  }
  if (*spheres < 1 || *spheres > most_spheres) {
    lines.reject(fmt::format("{} spheres (must be in [1, {}])", *spheres, most_spheres));
  }
  return *spheres;
}

/// Finds where a frame begins; checks of those before it, and of none: of all, only that they have
/// their lines.
Lines::Mark beginning(Lines& lines, std::optional<std::int64_t> number) {
  std::optional<Lines::Mark> last;
  std::int64_t frames = 0;
  while (!number || frames <= *number) {
    const Lines::Mark here = lines.mark();
    const std::string* line = lines.next();
    if (!line) break;
    if (line->find_first_not_of(xyz::blanks) == std::string::npos) continue;
    last = here;
    ++frames;
    const std::int64_t needed = spheres_in(*line, lines) + 1;
    for (std::int64_t read = 0; read < needed; ++read) {
      if (lines.next()) continue;
      lines.reject(fmt::format("the file ends (the frame that begins in line {} needs {} lines)",
                               here.number + 1, needed + 1));
    }
  }
  if (!last) lines.reject_file("is empty (needs a frame of extended XYZ)");
  if (number && frames <= *number) {
    lines.reject_file(
        fmt::format("has {} (start.snapshot = {}, counted from 0); choose one of them",
                    counted(frames, "frame"), *number));
  }
  return *last;
}

/// The lines of the spheres, one after the other.
class Rows {
 public:
  Rows(const xyz::Header& header, int dimension, Lines& lines)
      : columns_(header.columns),
        kind_names_(header.kind_names),
        origin_(header.origin),
        dimension_(dimension),
        lines_(lines) {}

  void read_next(XyzFrame& frame) {
    split(lines_.required());
    append(columns_.position, frame.positions);
    for (std::size_t axis = 0; axis < origin_.size(); ++axis) {
      frame.positions[frame.positions.size() - origin_.size() + axis] -= origin_[axis];
    }
    append(columns_.velocity, frame.velocities);
    std::optional<double> diameter;
    std::optional<double> mass;
    for (const auto& [name, column, expected] : columns_.fixed) {
      note(name, number_at(column) / expected, name.starts_with("mass") ? mass : diameter);
    }
    for (std::size_t n = dimension_ == 3 ? 0 : 2; n < columns_.spin.count; ++n) {
      frame.spins.push_back(number_at(columns_.spin.first + n));
    }
    if (diameter) frame.diameters.push_back(*diameter);
    if (mass) frame.masses.push_back(*mass);
    if (columns_.kind) frame.kinds.push_back(kind_in(words_[columns_.kind->column]));
    for (std::size_t n = 0; n < columns_.momentum.count; ++n) require_product(n, mass.value_or(1));
    if (columns_.has_momenta && mass) divide_velocity(frame, *mass);
    // X is the element without a name, whose mass is 1.
    const bool has_mass = columns_.has_masses || words_.front() == "X";
    if (columns_.has_momenta && !has_mass) frame.needs_masses = true;
  }

 private:
  void split(std::string_view line) {
    words_.clear();
    for (auto word = xyz::next_word(line); !word.empty(); word = xyz::next_word(line)) {
      words_.push_back(word);
    }
    if (!columns_.total || words_.size() == *columns_.total) return;
    if (words_.size() < *columns_.total) lines_.reject("has too few numbers");
    lines_.reject(fmt::format("has {} columns (Properties has {}); make them equal", words_.size(),
                              *columns_.total));
  }

  double number_at(std::size_t column) const {
    return xyz::finite_number(column < words_.size() ? words_[column] : "", lines_);
  }

  /// Appends the first D of the numbers in some columns; the others must be 0.
  void append(const xyz::Columns::Span& span, std::vector<double>& numbers) const {
    for (std::size_t n = 0; n < span.count; ++n) {
      const double number = number_at(span.first + n);
      if (n < static_cast<std::size_t>(dimension_)) {
        numbers.push_back(number);
      } else if (number != 0) {
        lines_.reject(fmt::format("column {} is {} (must be 0 where system.dimension = {})",
                                  span.first + n + 1, number, dimension_));
      }
    }
  }

  /// The word of a kind: of a number in a file that names its kinds, the name.
  std::string kind_in(std::string_view word) const {
    const auto number = xyz::number_in<std::size_t>(word);
    return std::string(number && *number < kind_names_.size() ? kind_names_[*number] : word);
  }

  /// Takes the diameter or mass that a column tells, which no other column contradicts.
  void note(const std::string& name, double size, std::optional<double>& noted) const {
    if (!(size > 0)) lines_.reject(fmt::format("{} is {} (must be > 0)", name, size));
    if (noted && std::abs(*noted - size) > xyz::file_accuracy * size) {
      lines_.reject(fmt::format("{} contradicts another column; keep one", name));
    }
    noted = size;
  }

  /// A component of the momentum beside the velocity must be mass times it.
  void require_product(std::size_t axis, double mass) const {
    const double momentum = number_at(columns_.momentum.first + axis);
    const double velocity = number_at(columns_.velocity.first + axis);
    if (std::abs(momentum - mass * velocity) <= xyz::file_accuracy * std::abs(mass * velocity)) {
      return;
    }
    lines_.reject(fmt::format("momentum {} beside {} {} (the mass is {:g}); keep one", momentum,
                              columns_.velocity_name, velocity, mass));
  }

  void divide_velocity(XyzFrame& frame, double mass) const {
    const auto components = static_cast<std::ptrdiff_t>(dimension_);
    std::for_each(frame.velocities.end() - components, frame.velocities.end(),
                  [mass](double& component) { component /= mass; });
  }

  static constexpr double equal = 1e-9;  // files in text often have ten digits

  const xyz::Columns& columns_;
  const std::vector<std::string>& kind_names_;
  const std::vector<double>& origin_;
  int dimension_;
  Lines& lines_;
  std::vector<std::string_view> words_;
};

}  // namespace

XyzFrame read_frame(const std::filesystem::path& path, int dimension, std::int64_t spheres,
                    std::optional<std::int64_t> number) {
  Lines lines(path);
  lines.go_back(beginning(lines, number));
  const std::int64_t found = spheres_in(lines.required(), lines);
  if (found != spheres) {
    lines.reject(fmt::format("has {} (system.spheres = {}); make them equal",
                             counted(found, "sphere"), spheres));
  }
  const std::string comment = lines.required();
  const xyz::Header header = xyz::header_of(comment, dimension, lines);
  XyzFrame frame{.positions = {},
                 .velocities = {},
                 .sides = header.lattice.sides,
                 .offset = header.lattice.offset,
                 .is_periodic = header.is_periodic};
  Rows rows(header, dimension, lines);
  for (std::int64_t i = 0; i < spheres; ++i) rows.read_next(frame);
  return frame;
}

}  // namespace zenosphere
