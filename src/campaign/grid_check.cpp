#include "campaign/grid_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "campaign/run_case.hpp"

namespace zenosphere {

namespace {

/// A case takes some 50 microseconds to read.
constexpr std::int64_t most_points_tried = 2000;
/// More lines than this are not read.
constexpr std::size_t most_lines = 50;

/// The problems of many cases, each line once, in the order in which they were found.
class Findings {
 public:
  explicit Findings(const Sweep& sweep) : sweep_(sweep) {}

  void try_point(const std::vector<std::size_t>& coordinates) {
    if (lines_.size() >= most_lines) return;
    try {
      require_digits(case_of_run(sweep_.base, sweep_.stop, entries(coordinates)));
    } catch (const InputError& error) {
      note(error.what());
    }
  }

  void throw_if_any() const {
    if (lines_.empty()) return;
    std::string all;
    for (const std::string& line : lines_) all += (all.empty() ? "" : "\n") + line;
    throw InputError(all);
  }

 private:
  /// The values of a point, which stand where the user wrote them.
  std::vector<case_format::Entry> entries(const std::vector<std::size_t>& coordinates) const {
    std::vector<case_format::Entry> entries;
    for (std::size_t n = 0; n < coordinates.size(); ++n) {
      const SweepAxis& axis = sweep_.axes[n];
      const AxisValue& value = axis.values[coordinates[n]];
      const auto place = case_format::Place::in_override(value.place.text, value.place.order[1]);
      entries.push_back({axis.key.table(), axis.key.name(), value.value, place, place});
    }
    return entries;
  }

  /// Notes where the runs have more digits than their adjudication may use.
  void require_digits(const Case& values) {
    if (!sweep_.adjudicate || !sweep_.adjudicate->up_to) return;
    const Precision highest = *sweep_.adjudicate->up_to;
    const Precision own = values.collision.precision;
    if (!(highest < own)) return;
    note(
        fmt::format("{}: adjudicate.up_to = \"{}\" (runs are in {} already, and digits cannot be "
                    "taken away); choose a higher one",
                    sweep_.adjudicate->place, highest.word(), own.word()));
  }

  void note(const std::string& text) {
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
      if (std::find(lines_.begin(), lines_.end(), line) == lines_.end()) lines_.push_back(line);
    }
  }

  const Sweep& sweep_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::size_t> coordinates_of(const std::vector<SweepAxis>& axes, std::int64_t point) {
  std::vector<std::size_t> coordinates(axes.size());
  for (std::size_t n = axes.size(); n-- > 0;) {
    const auto size = static_cast<std::int64_t>(axes[n].size());
    coordinates[n] = static_cast<std::size_t>(point % size);
    point /= size;
  }
  return coordinates;
}

void check_grid(const Sweep& sweep) {
  Findings findings(sweep);
  std::vector<std::size_t> first(sweep.axes.size(), 0);
  findings.try_point(first);
  for (std::size_t n = 0; n < sweep.axes.size(); ++n) {
    std::vector<std::size_t> coordinates = first;
    for (std::size_t value = 1; value < sweep.axes[n].size(); ++value) {
      coordinates[n] = value;
      findings.try_point(coordinates);
    }
  }
  const bool is_small = sweep.points() <= most_points_tried;
  for (std::int64_t point = 0; is_small && point < sweep.points(); ++point) {
    findings.try_point(coordinates_of(sweep.axes, point));
  }
  findings.throw_if_any();
}

}  // namespace zenosphere
