#include "campaign/grid_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>
#include <utility>
#include <vector>

#include "campaign/grid_check.hpp"
#include "campaign/seeds.hpp"

namespace zenosphere {

namespace {

/// The rows of a grid that grows.
class Rows {
 public:
  Rows(Database& database, const Sweep& sweep, const StoredSweep* before)
      : sweep_(sweep), old_seeds_(before ? before->seeds : 0), insert_(statement(database, sweep)) {
    for (std::size_t n = 0; n < sweep.axes.size(); ++n) {
      is_old_.emplace_back(sweep.axes[n].size(), false);
      if (before) mark_old(json_values(sweep.axes[n]), before->axes[n].values, is_old_.back());
    }
    if (!before || !grows()) return;
    next_run_ = database.integer("SELECT coalesce(max(run), -1) + 1 FROM run");
    next_point_ = database.integer("SELECT coalesce(max(point), -1) + 1 FROM run");
    read_points(database);
  }

  void add_missing() {
    if (!grows()) return;
    for (std::int64_t replica = 0; replica < sweep_.seeds; ++replica) {
      for (std::int64_t point = 0; point < sweep_.points(); ++point) {
        const auto coordinates = coordinates_of(sweep_.axes, point);
        if (!is_stored(replica, coordinates)) add(replica, point, coordinates);
      }
    }
  }

 private:
  static Statement statement(Database& database, const Sweep& sweep) {
    std::vector<AxisKey> keys;
    std::string marks;
    for (const SweepAxis& axis : sweep.axes) {
      keys.push_back(axis.key);
      marks += ", ?";
    }
    return database.statement(
        fmt::format("INSERT INTO run (run, point, replica, seed, status{}) VALUES (?, ?, ?, ?, "
                    "'pending'{})",
                    axis_columns(keys), marks));
  }

  /// Whether the sweep has anything that the store does not have.
  bool grows() const {
    const auto has_new = [](const std::vector<bool>& marks) {
      return std::find(marks.begin(), marks.end(), false) != marks.end();
    };
    return sweep_.seeds > old_seeds_ || std::any_of(is_old_.begin(), is_old_.end(), has_new);
  }

  static void mark_old(const std::vector<std::string>& values, const std::vector<std::string>& old,
                       std::vector<bool>& marks) {
    for (std::size_t n = 0; n < values.size(); ++n) {
      marks[n] = std::find(old.begin(), old.end(), values[n]) != old.end();
    }
  }

  bool is_stored(std::int64_t replica, const std::vector<std::size_t>& coordinates) const {
    if (replica >= old_seeds_) return false;
    for (std::size_t n = 0; n < coordinates.size(); ++n) {
      if (!is_old_[n][coordinates[n]]) return false;
    }
    return true;
  }

  /// Which number each point of the grid has in the store.
  void read_points(Database& database) {
    std::vector<AxisKey> keys;
    std::vector<std::unordered_map<std::string, std::int64_t>> indices(sweep_.axes.size());
    for (std::size_t n = 0; n < sweep_.axes.size(); ++n) {
      keys.push_back(sweep_.axes[n].key);
      for (std::size_t at = 0; at < sweep_.axes[n].size(); ++at) {
        const std::string text = cell_text(column_cell(sweep_.axes[n].values[at].value));
        indices[n][text] = static_cast<std::int64_t>(at);
      }
    }
    Statement query = database.statement(
        fmt::format("SELECT point{} FROM run WHERE replica = 0", axis_columns(keys)));
    while (query.step()) {
      std::int64_t place = 0;
      bool is_of_grid = true;
      for (std::size_t n = 0; n < keys.size(); ++n) {
        const auto found = indices[n].find(cell_text(query.cell(static_cast<int>(n) + 1)));
        is_of_grid = is_of_grid && found != indices[n].end();
        const auto size = static_cast<std::int64_t>(sweep_.axes[n].size());
        place = place * size + (found == indices[n].end() ? 0 : found->second);
      }
      if (is_of_grid) points_[place] = integer_in(query.cell(0), database.name());
    }
  }

  /// The number that the store has for a point of the grid; the next free one if it is new.
  std::int64_t number_of(std::int64_t point) {
    const auto [found, is_new] = points_.try_emplace(point, next_point_);
    if (is_new) ++next_point_;
    return found->second;
  }

  void add(std::int64_t replica, std::int64_t point, const std::vector<std::size_t>& coordinates) {
    const std::int64_t number = old_seeds_ == 0 ? point : number_of(point);
    cells_ = {next_run_, number, replica,
              static_cast<std::int64_t>(run_seed(static_cast<std::uint64_t>(sweep_.master_seed),
                                                 static_cast<std::uint64_t>(next_run_)))};
    for (std::size_t n = 0; n < coordinates.size(); ++n) {
      cells_.push_back(column_cell(sweep_.axes[n].values[coordinates[n]].value));
    }
    insert_.run(cells_);
    ++next_run_;
  }

  const Sweep& sweep_;
  std::int64_t old_seeds_;
  Statement insert_;
  std::vector<std::vector<bool>> is_old_;                    ///< by axis and value
  std::unordered_map<std::int64_t, std::int64_t> points_{};  ///< number in the store, by point
  std::int64_t next_run_ = 0;
  std::int64_t next_point_ = 0;
  std::vector<Cell> cells_{};
};

}  // namespace

Cell column_cell(const case_format::Value& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return *integer;
  if (const auto* real = std::get_if<double>(&value)) return *real;
  return column_text(value);
}

void add_rows(Database& database, const Sweep& sweep, const StoredSweep* before) {
  Rows(database, sweep, before).add_missing();
}

}  // namespace zenosphere
