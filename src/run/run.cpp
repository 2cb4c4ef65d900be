#include "run/run.hpp"

#include <utility>

#include "run/stepped_run.hpp"

namespace zenosphere {

namespace {

/// Goes on to the limits of the case in one piece.
Summary gone_through(SteppedRun& run) {
  run.advance({}, nullptr);
  return run.finish();
}

}  // namespace

Summary run_case(const Case& values, const RunOptions& options) {
  return gone_through(*start_run(values, options));
}

Summary resume_case(const Case& values, RecoveredOutput output, const RunOptions& options) {
  return gone_through(*resumed_run(values, std::move(output), options));
}

}  // namespace zenosphere
