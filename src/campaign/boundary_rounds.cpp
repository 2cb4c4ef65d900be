#include "campaign/boundary_rounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "campaign/grid_check.hpp"
#include "campaign/grid_rows.hpp"
#include "campaign/run_columns.hpp"
#include "campaign/seeds.hpp"

namespace zenosphere {

namespace {

std::vector<SweepAxis> other_axes(const Sweep& sweep) {
  return {sweep.axes.begin(), sweep.axes.end() - 1};
}

std::vector<AxisKey> keys_of(const std::vector<SweepAxis>& axes) {
  std::vector<AxisKey> keys;
  for (const SweepAxis& axis : axes) keys.push_back(axis.key);
  return keys;
}

/// `?, ?, ?`
std::string marks(std::size_t count) {
  std::string text;
  for (std::size_t n = 0; n < count; ++n) text += n == 0 ? "?" : ", ?";
  return text;
}

bool has_boundary_table(Database& database) {
  return database.integer("SELECT count(*) FROM sqlite_master WHERE name = 'boundary'") > 0;
}

/// A length along the axis, or nothing where it is outside the range.
Cell inside(double x, const SearchRange& range) {
  Cell cell;
  if (x >= range.from && x <= range.to) cell = x;
  return cell;
}

double number_in(const Cell& cell) {
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return static_cast<double>(*whole);
  const auto* real = std::get_if<double>(&cell);
  return real ? *real : 0;
}

}  // namespace

void create_boundary_table(Database& database, const Sweep& sweep) {
  std::string columns = "point INTEGER PRIMARY KEY";
  for (const SweepAxis& axis : other_axes(sweep)) {
    columns += fmt::format(", \"{}\" {} NOT NULL", axis.path(), sqlite_type(axis.key.storage()));
  }
  database.execute(fmt::format(
      "CREATE TABLE boundary ({}, axis TEXT NOT NULL, criterion TEXT NOT NULL, \"from\" REAL NOT "
      "NULL, \"to\" REAL NOT NULL, resolution REAL NOT NULL, finding TEXT NOT NULL, place REAL, "
      "low "
      "REAL, high REAL, rounds INTEGER NOT NULL, runs INTEGER NOT NULL, failed INTEGER NOT NULL)",
      columns));
}

void require_same_search(Database& database, const Sweep& sweep) {
  const bool is_search = has_boundary_table(database);
  if (is_search != sweep.boundary.has_value()) {
    throw InputError(fmt::format(
        "{}: holds {}, {} describes {} (they cannot share a store); choose another store with -o",
        database.name(), is_search ? "a search" : "a grid", sweep.name,
        is_search ? "a grid" : "a search"));
  }
  if (!is_search) return;
  const Cell criterion = database.value("SELECT criterion FROM boundary");
  const auto* word = std::get_if<std::string>(&criterion);
  if (!word || *word == sweep.boundary->criterion_word()) return;
  throw InputError(
      fmt::format("{}: boundary.criterion is \"{}\" (\"{}\" in the store); choose another store "
                  "with -o",
                  database.name(), sweep.boundary->criterion_word(), *word));
}

BoundaryRounds::BoundaryRounds(Database& database, const Sweep& sweep)
    : database_(database), sweep_(sweep) {
  const std::vector<SweepAxis> others = other_axes(sweep);
  std::int64_t count = 1;
  for (const SweepAxis& axis : others) count *= static_cast<std::int64_t>(axis.size());
  for (std::int64_t point = 0; point < count; ++point) {
    const auto coordinates = coordinates_of(others, point);
    std::vector<Cell> cells;
    for (std::size_t n = 0; n < others.size(); ++n) {
      cells.push_back(column_cell(others[n].values[coordinates[n]].value));
    }
    points_.push_back({std::move(cells), BoundarySearch(sweep.boundary->range)});
  }
}

bool BoundaryRounds::place_next() {
  learn();
  Transaction transaction(database_);
  write_table();
  const bool goes_on = add_runs();
  transaction.commit();
  return goes_on;
}

void BoundaryRounds::learn() {
  const std::string met = sweep_.boundary->criterion == BoundaryRequest::Criterion::arrest
                              ? "arrest_met = 1"
                              : "separation_hits > 0";
  Statement query = database_.statement(
      fmt::format("SELECT run, point, replica, status = 'done' AND ended_by IS "
                  "NOT {}, coalesce({}, 0), \"{}\" FROM run "
                  "WHERE run >= ? ORDER BY run",
                  sql_word(EndedBy::wall_time), met, sweep_.axes.back().path()));
  query.start(std::array<Cell, 1>{next_run_});
  const auto integer = [&](int column) { return integer_in(query.cell(column), database_.name()); };
  while (query.step()) {
    next_run_ = integer(0) + 1;
    Point& point = points_.at(static_cast<std::size_t>(integer(1)));
    point.rounds = integer(2) + 1;
    if (integer(3) == 1) {
      point.search.observe(number_in(query.cell(5)), integer(4) == 1);
    } else {
      point.search.observe_failure();
      ++point.failed;
    }
  }
}

void BoundaryRounds::write_table() {
  const SearchRange& range = sweep_.boundary->range;
  const auto others = keys_of(other_axes(sweep_));
  Statement insert = database_.statement(fmt::format(
      "INSERT OR REPLACE INTO boundary (point{}, axis, criterion, \"from\", \"to\", resolution, "
      "finding, place, low, high, rounds, runs, failed) VALUES ({})",
      axis_columns(others), marks(others.size() + 13)));
  for (std::size_t n = 0; n < points_.size(); ++n) {
    const Point& point = points_[n];
    const Estimate estimate = point.search.estimate();
    std::vector<Cell> cells{static_cast<std::int64_t>(n)};
    cells.insert(cells.end(), point.cells.begin(), point.cells.end());
    const std::vector<Cell> rest{sweep_.axes.back().path(),
                                 std::string(sweep_.boundary->criterion_word()),
                                 range.from,
                                 range.to,
                                 range.resolution,
                                 std::string(word_of(point.search.finding())),
                                 inside(estimate.place, range),
                                 inside(estimate.low, range),
                                 inside(estimate.high, range),
                                 point.rounds,
                                 point.search.runs(),
                                 point.failed};
    cells.insert(cells.end(), rest.begin(), rest.end());
    insert.run(cells);
  }
}

bool BoundaryRounds::add_runs() {
  Statement insert = database_.statement(
      fmt::format("INSERT INTO run (run, point, replica, seed, status{}) VALUES (?, ?, ?, ?, "
                  "'pending', {})",
                  axis_columns(keys_of(sweep_.axes)), marks(sweep_.axes.size())));
  const bool is_whole = sweep_.boundary->range.is_whole;
  std::int64_t run = next_run_;
  for (std::size_t n = 0; n < points_.size(); ++n) {
    for (const double x : points_[n].search.next_round()) {
      const auto seed =
          run_seed(static_cast<std::uint64_t>(sweep_.master_seed), static_cast<std::uint64_t>(run));
      std::vector<Cell> cells{run, static_cast<std::int64_t>(n), points_[n].rounds,
                              static_cast<std::int64_t>(seed)};
      cells.insert(cells.end(), points_[n].cells.begin(), points_[n].cells.end());
      if (is_whole) {
        cells.emplace_back(static_cast<std::int64_t>(x));
      } else {
        cells.emplace_back(x);
      }
      insert.run(cells);
      ++run;
    }
  }
  return run > next_run_;
}

std::vector<FoundBoundary> BoundaryRounds::found() const {
  std::vector<FoundBoundary> found;
  for (const Point& point : points_) {
    std::vector<std::string> values;
    for (const Cell& cell : point.cells) values.push_back(cell_text(cell));
    found.push_back({std::move(values), point.search.finding(), point.search.estimate(),
                     point.rounds, point.search.runs()});
  }
  return found;
}

}  // namespace zenosphere
