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

/// A run in Digits: whoever calls it, and on whichever thread, the numbers have their precision.
class RunInDigits : public SteppedRun {
 public:
  RunInDigits(std::unique_ptr<SteppedRun> run, int bits) : run_(std::move(run)), bits_(bits) {}

  void advance(const Piece& piece, std::vector<CollisionRow>* rows) override {
    const WorkingPrecision here(bits_);
    run_->advance(piece, rows);
  }
  bool is_over() const override { return run_->is_over(); }
  std::int64_t collisions() const override { return run_->collisions(); }
  double time() const override {
    const WorkingPrecision here(bits_);
    return run_->time();
  }
  Summary summary() const override {
    const WorkingPrecision here(bits_);
    return run_->summary();
  }
  SphereState state() const override {
    const WorkingPrecision here(bits_);
    return run_->state();
  }
  void save() override {
    const WorkingPrecision here(bits_);
    run_->save();
  }
  Summary finish() override {
    const WorkingPrecision here(bits_);
    return run_->finish();
  }

 private:
  std::unique_ptr<SteppedRun> run_;
  int bits_;
};

std::unique_ptr<SteppedRun> in_its_precision(const Case& values, std::unique_ptr<SteppedRun> run) {
  const Precision precision = values.collision.precision;
  if (!precision.is_digits()) return run;
  return std::make_unique<RunInDigits>(std::move(run), precision.bits());
}

}  // namespace

std::unique_ptr<SteppedRun> start_run(const Case& values, const RunOptions& options) {
  if (options.output) OutputFile::check_target(*options.output, options.existing);
  return in_its_precision(
      values, in_arithmetic_of(values, [&]<int Dim, class Real>() -> std::unique_ptr<SteppedRun> {
        return std::make_unique<Run<Dim, Real>>(values, options);
      }));
}

std::unique_ptr<SteppedRun> resumed_run(const Case& values, RecoveredOutput output,
                                        const RunOptions& options) {
  return in_its_precision(values, in_arithmetic_of(values, [&]<int Dim, class Real>() {
                            return gone_on<Dim, Real>(values, std::move(output), options);
                          }));
}

}  // namespace zenosphere
