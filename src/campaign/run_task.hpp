#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "campaign/sweep.hpp"
#include "io/summary.hpp"

namespace zenosphere {

/// A run that is to be done.
struct RunTask {
  std::int64_t run = 0;                  ///< its number in the store
  std::vector<std::string> overrides{};  ///< axis values and seed, as arguments of `--set`
};

/// A run that was given up because the sweep was to end: as if it had not begun.
struct Dropped {};
/// A run that could not be done, with the reason.
struct Failure {
  std::string error;
};

/// What has become of a run.
struct RunResult {
  std::int64_t run = 0;
  std::variant<Dropped, Failure, Summary> outcome;
};

/// What all runs of a sweep share.
struct RunSetting {
  CaseDraft base;
  StopRule stop;
};

/// Does a run, whatever comes of it.
///
/// \param is_cancelled  asked a few times a second; true ends the run, which is dropped then
RunResult result_of(const RunTask& task, const RunSetting& setting,
                    const std::function<bool()>& is_cancelled);

/// The same for a case that is made already.
RunResult result_of(std::int64_t run, const Case& values, const StopRule& stop,
                    const std::function<bool()>& is_cancelled);

}  // namespace zenosphere
