#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>

#include "case/case.hpp"
#include "result/summary.hpp"
#include "storage/output_file.hpp"
#include "storage/recovery.hpp"

namespace zenosphere {

/// How far a run has come: what the progress line shows.
struct Progress {
  std::int64_t collisions = 0;
  double time = 0;
  double collisions_per_second = 0;
  std::int64_t separation_hits = 0;
  double done = 0;  ///< fraction of the run's limits, in [0, 1]
  double wall_seconds = 0;
};

/// What surrounds a run, besides its case.
struct RunOptions {
  std::optional<std::filesystem::path> output;  ///< none: nothing is written
  Existing existing = Existing::refuse;
  const std::atomic<bool>* interrupt = nullptr;        ///< set from outside to end the run early
  std::function<void(const Progress&)> on_progress{};  ///< called a few times a second
};

/// Runs a case to its limits, with everything observed and recorded, and sums it up.
///
/// An interrupt ends the run as a limit does: everything is written.
/// Throws InputError where the start cannot be made, OutputError where the file cannot be written.
Summary run_case(const Case& values, const RunOptions& options);

/// Goes on with a run from its last checkpoint, to the limits of the case.
///
/// \param values   from case_to_resume
/// \param options  the output is the recovered one, whatever they say
/// Throws InputError where the checkpoint is damaged or of another version, OutputError where the
/// files cannot be written.
Summary resume_case(const Case& values, RecoveredOutput output, const RunOptions& options);

}  // namespace zenosphere
