#include "campaign/run_task.hpp"

#include <atomic>
#include <exception>

#include "campaign/run_case.hpp"
#include "run/run.hpp"

namespace zenosphere {

namespace {

/// A run, with its own flag to end it.
std::variant<Dropped, Failure, Summary> outcome_of(const Case& values, const StopRule& stop,
                                                   const std::function<bool()>& is_cancelled) {
  std::atomic<bool> is_to_end{false};
  bool is_too_long = false;
  RunOptions options;
  options.interrupt = &is_to_end;
  options.on_progress = [&](const Progress& progress) {
    is_too_long = stop.wall_seconds && progress.wall_seconds > *stop.wall_seconds;
    if (is_too_long || is_cancelled()) is_to_end = true;
  };
  Summary summary = run_case(values, options);
  if (summary.self_check) return Failure{*summary.self_check};
  if (summary.ended_by == "signal") {
    if (!is_too_long) return Dropped{};
    summary.ended_by = "wall time";
  }
  return summary;
}

}  // namespace

RunResult result_of(std::int64_t run, const Case& values, const StopRule& stop,
                    const std::function<bool()>& is_cancelled) {
  try {
    return {run, outcome_of(values, stop, is_cancelled)};
  } catch (const std::exception& error) {
    return {run, Failure{error.what()}};
  }
}

RunResult result_of(const RunTask& task, const RunSetting& setting,
                    const std::function<bool()>& is_cancelled) {
  try {
    const Case values = case_of_run(setting.base, setting.stop, task.overrides);
    return result_of(task.run, values, setting.stop, is_cancelled);
  } catch (const std::exception& error) {
    return {task.run, Failure{error.what()}};
  }
}

}  // namespace zenosphere
