#include "campaign/estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "campaign/boundary_rounds.hpp"
#include "campaign/run_case.hpp"
#include "campaign/run_columns.hpp"
#include "run/run.hpp"

namespace zenosphere {

namespace {

using Overrides = std::vector<std::string>;

constexpr std::int64_t most_probes = 5;
constexpr double probe_seconds = 0.5;

/// Seconds that one run takes, from its beginning; nothing where it cannot be run.
std::optional<double> probe(const Sweep& sweep, const Overrides& overrides,
                            const std::atomic<bool>* interrupt) {
  std::atomic<bool> is_enough{false};
  double done = 1;
  RunOptions options;
  options.interrupt = &is_enough;
  options.on_progress = [&](const Progress& progress) {
    if (progress.wall_seconds < probe_seconds && !(interrupt && *interrupt)) return;
    done = progress.done;
    is_enough = true;
  };
  try {
    const Stopwatch stopwatch;
    run_case(case_of_run(sweep.base, sweep.stop, overrides), options);
    const double seconds = stopwatch.seconds() / std::max(done, 1e-12);
    return std::min(seconds, sweep.stop.wall_seconds.value_or(seconds));
  } catch (const std::exception&) {
    return std::nullopt;  // the sweep will record it
  }
}

/// What some runs, spread evenly over so many, take.
struct Probes {
  double sum = 0;  ///< seconds
  int worked = 0;

  /// \param overrides_of  of the run with a number from 0 to count - 1
  template <class OverridesOf>
  Probes(const Sweep& sweep, std::int64_t count, const std::atomic<bool>* interrupt,
         OverridesOf overrides_of) {
    const std::int64_t probes = std::min(most_probes, count);
    for (std::int64_t n = 0; n < probes && !(interrupt && *interrupt); ++n) {
      const std::int64_t place = probes == 1 ? 0 : n * (count - 1) / (probes - 1);
      const auto seconds = probe(sweep, overrides_of(place), interrupt);
      if (!seconds) continue;
      sum += *seconds;
      ++worked;
    }
  }

  double mean() const { return worked > 0 ? sum / worked : 0; }
  std::string text() const {
    return fmt::format("{} short probe{}, stretched to their limits", worked,
                       worked == 1 ? "" : "s");
  }
};

void estimate_by_probes(SweepPlan& plan, const Sweep& sweep, const std::atomic<bool>* interrupt) {
  const Probes probes(sweep, sweep.points(), interrupt,
                      [&](std::int64_t point) { return overrides_of(sweep, point); });
  plan.seconds_per_run = probes.mean();
  plan.source = "from " + probes.text();
}

/// Where all runs that are done tell what one takes: of a search, and where nothing is left.
bool estimate_by_mean(SweepPlan& plan, Database& database) {
  const Cell mean = database.value("SELECT avg(wall_seconds) FROM run WHERE status = 'done'");
  const auto* seconds = std::get_if<double>(&mean);
  if (!seconds) return false;
  plan.seconds_per_run = *seconds;
  plan.source = fmt::format("from the {} runs done", plan.counts.done);
  return true;
}

/// What is left to do in a store.
struct Left {
  double seconds = 0;                ///< of the runs at points whose runs that are done tell it
  std::int64_t told_points = 0;      ///< number of those points
  std::int64_t told_runs = 0;        ///< runs left at them
  std::vector<std::int64_t> untold;  ///< a run left at each of the other points
};

Left left_in(Database& database) {
  Left left;
  Statement points = database.statement(fmt::format(
      "SELECT min(CASE WHEN status = 'pending' THEN run END), sum(status = 'pending'), "
      "avg(CASE WHEN status = 'done' THEN wall_seconds END), sum(status = 'done') >= 3 OR "
      "max(status = 'done' AND ended_by IN ({}, {})) FROM run GROUP BY point HAVING "
      "sum(status = 'pending') > 0",
      sql_word(EndedBy::collisions), sql_word(EndedBy::time)));
  while (points.step()) {
    const std::int64_t pending = integer_in(points.cell(1), database.name());
    const Cell mean = points.cell(2);
    const auto* seconds = std::get_if<double>(&mean);
    if (!seconds || integer_in(points.cell(3), database.name()) == 0) {
      left.untold.push_back(integer_in(points.cell(0), database.name()));
      continue;
    }
    left.seconds += *seconds * static_cast<double>(pending);
    left.told_runs += pending;
    ++left.told_points;
  }
  return left;
}

void estimate_by_points(SweepPlan& plan, const Sweep& sweep, Database& database,
                        const StoredSweep& stored, const std::atomic<bool>* interrupt) {
  const Left left = left_in(database);
  const std::int64_t untold_runs = plan.counts.pending - left.told_runs;
  std::string probed;
  double seconds = left.seconds;
  if (untold_runs > 0) {
    StoredRuns runs(database, stored);
    const auto count = static_cast<std::int64_t>(left.untold.size());
    // Points that the sweep file has got since are not in the store: then the grid is probed.
    const Probes probes =
        count > 0 ? Probes(sweep, count, interrupt,
                           [&](std::int64_t n) {
                             return runs.run(left.untold[static_cast<std::size_t>(n)]).overrides;
                           })
                  : Probes(sweep, sweep.points(), interrupt,
                           [&](std::int64_t point) { return overrides_of(sweep, point); });
    seconds += probes.mean() * static_cast<double>(untold_runs);
    probed = probes.text();
  }
  plan.seconds_per_run =
      seconds / static_cast<double>(std::max<std::int64_t>(plan.counts.pending, 1));
  if (left.told_points > 0) {
    plan.source = fmt::format("from the runs done at {} point{}{}", left.told_points,
                              left.told_points == 1 ? "" : "s", probed.empty() ? "" : " and ");
  } else {
    plan.source = "from ";
  }
  plan.source += probed;
}

}  // namespace

double SweepPlan::seconds(std::size_t workers) const {
  const auto left = static_cast<double>(counts.pending);
  const double at_once = std::max(std::min(static_cast<double>(workers), left), 1.0);
  return seconds_per_run * left / at_once;
}

SweepPlan plan_of(const Sweep& sweep, const std::optional<std::string>& store,
                  const std::atomic<bool>* interrupt) {
  SweepPlan plan;
  if (store) {
    Database database(*store, Database::Access::read);
    StoredSweep stored = stored_sweep(database);
    require_same_search(database, sweep);
    require_same(stored, sweep, *store);
    stored.adjudicate = sweep.adjudicate;  // as the store will be extended
    plan.counts = run_counts(database, stored);
    plan.counts.pending = sweep.runs() - plan.counts.done - plan.counts.failed;
    if (plan.counts.pending > 0 && !sweep.boundary) {
      estimate_by_points(plan, sweep, database, stored, interrupt);
      return plan;
    }
    if (estimate_by_mean(plan, database)) return plan;
  }
  plan.counts.pending = sweep.runs() - plan.counts.failed;
  estimate_by_probes(plan, sweep, interrupt);
  return plan;
}

}  // namespace zenosphere
