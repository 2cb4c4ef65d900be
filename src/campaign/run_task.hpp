#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "campaign/adjudication_request.hpp"
#include "campaign/database.hpp"
#include "campaign/sweep.hpp"
#include "result/summary.hpp"

namespace zenosphere {

/// A run that was done before, of which only the hits are to be adjudicated now.
struct DoneRun {
  std::optional<std::int64_t> collisions{};  ///< how far it came where its wall time ended it
};

/// A run that is to be done.
struct RunTask {
  std::int64_t run = 0;                  ///< its number in the store
  std::vector<std::string> overrides{};  ///< axis values and seed, as arguments of `--set`
  std::optional<DoneRun> done{};
};

/// A run that was given up because the sweep was to end: as if it had not begun.
struct Dropped {};
/// A run that was done before: its summary stays as it is.
struct Unchanged {};
/// A run that could not be done, with the reason.
struct Failure {
  std::string error;
};

/// What came of adjudicating the hits of a run.
struct AdjudicationResult {
  std::vector<Cell> cells{};           ///< of all adjudication_columns(), unless it failed
  std::optional<std::string> error{};  ///< why it did
};

/// What has become of a run.
struct RunResult {
  std::int64_t run = 0;
  std::variant<Dropped, Unchanged, Failure, Summary> outcome;
  std::optional<AdjudicationResult> adjudication{};  ///< none: no hit, or not asked for
};

/// How a run is done, besides what its case says.
struct RunRules {
  std::optional<double> wall_seconds{};
  std::optional<AdjudicationRequest> adjudicate{};
  std::optional<DoneRun> done{};
};

/// What all runs of a sweep share.
struct RunSetting {
  CaseTemplate base;
  StopRule stop;
  std::optional<AdjudicationRequest> adjudicate{};

  RunRules rules(const RunTask& task) const { return {stop.wall_seconds, adjudicate, task.done}; }
};

/// Does a run, whatever comes of it, and adjudicates its hits where that is asked for.
///
/// An adjudication that cannot be done leaves the run as it is, with the reason.
///
/// \param is_cancelled  asked a few times a second; true ends the run, which is dropped then
RunResult result_of(const RunTask& task, const RunSetting& setting,
                    const std::function<bool()>& is_cancelled);

/// The same for a case that is made already.
RunResult result_of(std::int64_t run, const Case& values, const RunRules& rules,
                    const std::function<bool()>& is_cancelled);

/// A run that cannot be done, or not be adjudicated where that is all there is to do.
RunResult failed_result(std::int64_t run, const RunRules& rules, const std::string& error);

}  // namespace zenosphere
