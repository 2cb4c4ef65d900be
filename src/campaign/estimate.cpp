#include "campaign/estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "campaign/boundary_rounds.hpp"
#include "campaign/run_case.hpp"
#include "run/run.hpp"

namespace zenosphere {

namespace {

constexpr std::int64_t probes = 5;
constexpr double probe_seconds = 0.5;

/// Seconds that one run takes, from its beginning; nothing where it cannot be run.
std::optional<double> probe(const Sweep& sweep, std::int64_t run,
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
    run_case(case_of_run(sweep.base, sweep.stop, overrides_of(sweep, run)), options);
    return stopwatch.seconds() / std::max(done, 1e-12);
  } catch (const std::exception&) {
    return std::nullopt;  // the sweep will record it
  }
}

void estimate_by_probes(SweepPlan& plan, const Sweep& sweep, const std::atomic<bool>* interrupt) {
  const std::int64_t count = std::min(probes, sweep.points());
  double sum = 0;
  int worked = 0;
  for (std::int64_t n = 0; n < count && !(interrupt && *interrupt); ++n) {
    const std::int64_t point = count == 1 ? 0 : n * (sweep.points() - 1) / (count - 1);
    const auto seconds = probe(sweep, point, interrupt);
    if (!seconds) continue;
    sum += *seconds;
    ++worked;
  }
  plan.seconds_per_run = worked > 0 ? sum / worked : 0;
  plan.source = fmt::format("from {} short probes", worked);
}

/// Whether the store tells what its runs took.
bool estimate_by_store(SweepPlan& plan, Database& database) {
  const Cell mean = database.value("SELECT avg(wall_seconds) FROM run WHERE status = 'done'");
  const auto* seconds = std::get_if<double>(&mean);
  if (!seconds) return false;
  plan.seconds_per_run = *seconds;
  plan.source = fmt::format("from the {} runs done", plan.counts.done);
  return true;
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
    if (estimate_by_store(plan, database)) return plan;
  }
  plan.counts.pending = sweep.runs() - plan.counts.failed;
  estimate_by_probes(plan, sweep, interrupt);
  return plan;
}

}  // namespace zenosphere
