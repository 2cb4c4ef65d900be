#include "campaign/run_task.hpp"

#include <atomic>
#include <exception>
#include <stdexcept>
#include <utility>

#include "campaign/adjudication_columns.hpp"
#include "campaign/run_case.hpp"
#include "run/adjudicate.hpp"
#include "run/run.hpp"
#include "run/stopwatch.hpp"
#include "start/start_species.hpp"

namespace zenosphere {

namespace {

using RunOutcome = decltype(RunResult::outcome);

/// A run, with its own flag to end it.
RunOutcome outcome_of_run(const Case& values, const std::optional<double>& wall_seconds,
                          const std::function<bool()>& is_cancelled) {
  std::atomic<bool> is_to_end{false};
  bool is_too_long = false;
  RunOptions options;
  options.interrupt = &is_to_end;
  options.on_progress = [&](const Progress& progress) {
    is_too_long = wall_seconds && progress.wall_seconds > *wall_seconds;
    if (is_too_long || is_cancelled()) is_to_end = true;
  };
  Summary summary = run_case(values, options);
  if (summary.self_check) return Failure{*summary.self_check};
  if (summary.ended_by == EndedBy::signal) {
    if (!is_too_long) return Dropped{};
    summary.ended_by = EndedBy::wall_time;
  }
  return summary;
}

/// Adjudicates the hits of a run; nothing where that was cancelled.
///
/// \param collisions  that the run did, where its wall time ended it: its hits are those up to
/// there
std::optional<AdjudicationResult> adjudicated(Case values,
                                              const std::optional<std::int64_t>& collisions,
                                              const AdjudicationRequest& request,
                                              const std::function<bool()>& is_cancelled) {
  if (collisions) values.run.collisions = *collisions;
  std::atomic<bool> is_to_end{false};
  const auto look = [&] {
    if (is_cancelled()) is_to_end = true;
  };
  const AdjudicationLimits limits{.highest = request.up_to,
                                  .collisions = request.collisions,
                                  .groups = request.groups,
                                  .seconds = request.seconds,
                                  .tries_other_rules = false,  // of no column
                                  .interrupt = &is_to_end,
                                  .on_look = look};
  try {
    const Stopwatch stopwatch;
    TimedAdjudication timed{.found = adjudicate(values, limits)};
    timed.seconds = stopwatch.seconds();
    if (timed.found.is_without_hits) throw std::logic_error(timed.found.sentence);  // there were
    if (!is_to_end) return AdjudicationResult{.cells = adjudication_cells(timed)};
  } catch (const std::exception& error) {
    // One that was interrupted before it saw a hit says that there are none.
    if (!is_to_end) return AdjudicationResult{.error = error.what()};
  }
  return std::nullopt;
}

/// What is to be adjudicated of an outcome, if anything.
std::optional<DoneRun> run_with_hits(const RunOutcome& outcome) {
  const auto* summary = std::get_if<Summary>(&outcome);
  if (!summary || summary->separation.hits == 0) return std::nullopt;
  const bool is_cut_off = summary->ended_by == EndedBy::wall_time;
  return DoneRun{is_cut_off ? std::optional(summary->collisions) : std::nullopt};
}

}  // namespace

RunResult result_of(std::int64_t run, const Case& told, const RunRules& rules,
                    const std::function<bool()>& is_cancelled) {
  try {
    const Case values = with_species_of_start(told);
    RunResult result{run, Unchanged{}};
    if (!rules.done) result.outcome = outcome_of_run(values, rules.wall_seconds, is_cancelled);
    const auto done = rules.done ? rules.done : run_with_hits(result.outcome);
    if (!rules.adjudicate || !done) return result;
    result.adjudication = adjudicated(values, done->collisions, *rules.adjudicate, is_cancelled);
    return result.adjudication ? result : RunResult{run, Dropped{}};
  } catch (const std::exception& error) {
    return failed_result(run, rules, error.what());
  }
}

RunResult result_of(const RunTask& task, const RunSetting& setting,
                    const std::function<bool()>& is_cancelled) {
  const RunRules rules = setting.rules(task);
  try {
    const Case values = case_of_run(setting.base, setting.stop, task.overrides);
    return result_of(task.run, values, rules, is_cancelled);
  } catch (const std::exception& error) {
    return failed_result(task.run, rules, error.what());
  }
}

RunResult failed_result(std::int64_t run, const RunRules& rules, const std::string& error) {
  if (rules.done) return {run, Unchanged{}, AdjudicationResult{.error = error}};
  return {run, Failure{error}};
}

}  // namespace zenosphere
