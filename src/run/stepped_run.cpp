#include "run/stepped_run.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "model/errors.hpp"
#include "run/arithmetic.hpp"
#include "run/run_loop.hpp"

namespace zenosphere {

namespace {

template <int Dim, class Real>
std::unique_ptr<SteppedRun> gone_on(const Case& values, RecoveredOutput output,
                                    const RunOptions& options) {
  const std::string name = output.path.string();
  try {
    const Bytes bytes = std::move(output.checkpoint.state);
    ArchiveReader state(bytes);
    require_known_state<Dim, Real>(values, output, state);
    return std::make_unique<Run<Dim, Real>>(values, options, std::move(output), state);
  } catch (const ArchiveError& error) {
    throw InputError(fmt::format("{}: has a checkpoint that is damaged ({}); run the case again",
                                 name, error.what()));
  }
}

}  // namespace

std::unique_ptr<SteppedRun> start_run(const Case& values, const RunOptions& options) {
  if (options.output) OutputFile::check_target(*options.output, options.existing);
  return in_arithmetic_of(values, [&]<int Dim, class Real>() -> std::unique_ptr<SteppedRun> {
    return std::make_unique<Run<Dim, Real>>(values, options);
  });
}

std::unique_ptr<SteppedRun> resumed_run(const Case& values, RecoveredOutput output,
                                        const RunOptions& options) {
  return in_arithmetic_of(values, [&]<int Dim, class Real>() {
    return gone_on<Dim, Real>(values, std::move(output), options);
  });
}

}  // namespace zenosphere
