#pragma once

#include <span>
#include <string>

#include "case/case.hpp"
#include "storage/recovery.hpp"

namespace zenosphere {

/// The case of a recovered run, with the end of the run set anew, or with more digits.
///
/// A higher precision takes its own gap threshold, unless the case has set one.
///
/// \param overrides  as `--set` has them; of run.collisions, run.time, collision.precision,
///                   collapse.stop_when_collapsed and output.checkpoint_* only: another key would
///                   make it another run
/// Throws InputError for other keys, for a lower precision, and where the run is over already under
/// the new values.
Case case_to_resume(const RecoveredOutput& output, std::span<const std::string> overrides);

}  // namespace zenosphere
