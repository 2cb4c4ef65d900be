#include "python/driven_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "model/errors.hpp"
#include "python/arrays.hpp"
#include "python/collision_rows.hpp"
#include "python/files.hpp"
#include "result/summary.hpp"
#include "run/resume.hpp"
#include "storage/recovery.hpp"

namespace zenosphere {

namespace {

namespace py = pybind11;

Piece piece_of(std::optional<std::int64_t> collisions, std::optional<double> until) {
  Piece piece;
  if (collisions && *collisions < 0) {
    throw InputError(fmt::format("advance: collisions = {} (must be >= 0)", *collisions));
  }
  if (until && !(*until >= 0)) {
    throw InputError(fmt::format("advance: until = {} (must be a time >= 0)", *until));
  }
  if (collisions) piece.collisions = *collisions;
  if (until) piece.time = *until;
  piece.seconds = 0.1;  // then Python's signals are looked at
  return piece;
}

}  // namespace

/// Keeps other threads off the run as long as it lives. Made and destroyed with Python's lock.
class DrivenRun::Use {
 public:
  explicit Use(const DrivenRun& run) : run_(run) {
    if (run.is_used_) {
      throw std::runtime_error(
          "zenosphere.Run: is in use by another thread (one at a time); wait for it, or stop() it");
    }
    run.is_used_ = true;
  }
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;
  ~Use() { run_.is_used_ = false; }

 private:
  const DrivenRun& run_;
};

DrivenRun::DrivenRun(const Case& values, const std::optional<std::string>& output,
                     Existing existing)
    : values_(values), has_output_(output.has_value()) {
  const py::gil_scoped_release unlocked;
  RunOptions options;
  options.output = output;
  options.existing = existing;
  options.interrupt = &interrupt_;
  files.write([&] { run_ = start_run(values_, options); });
  look();
}

DrivenRun::DrivenRun(const std::string& output, const std::vector<std::string>& overrides)
    : has_output_(true) {
  const py::gil_scoped_release unlocked;
  RecoveredOutput recovered = files.read([&] { return recover(output); });
  values_ = case_to_resume(recovered, overrides);
  RunOptions options;
  options.interrupt = &interrupt_;
  files.write([&] { run_ = resumed_run(values_, std::move(recovered), options); });
  look();
}

void DrivenRun::look() { seen_ = {run_->collisions(), run_->time(), end_ || run_->is_over()}; }

/// Does what may write to the output; after a failure nothing can be written any more.
template <class Action>
void DrivenRun::attempt(Action action) {
  const py::gil_scoped_release unlocked;
  try {
    has_output_ ? files.write(action) : action();
  } catch (const std::exception& error) {
    const py::gil_scoped_acquire locked;
    failure_ = error.what();
    look();
    throw;
  }
}

void DrivenRun::require_open() const {
  if (failure_) throw OutputError(*failure_);
  if (end_) {
    throw std::runtime_error(
        "zenosphere.Run: is finished; to make it longer, resume its file with a larger "
        "run.collisions or run.time");
  }
}

void DrivenRun::go_on(std::optional<std::int64_t> collisions, std::optional<double> until,
                      std::vector<CollisionRow>* rows) {
  const Use use(*this);
  require_open();
  Piece piece = piece_of(collisions, until);
  const std::int64_t begun = run_->collisions();
  for (;;) {
    attempt([&] { run_->advance(piece, rows); });
    look();
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (run_->is_over() || run_->time() >= piece.time) return;
    if (!collisions) continue;
    piece.collisions = *collisions - (run_->collisions() - begun);
    if (piece.collisions <= 0) return;
  }
}

py::array DrivenRun::advance(std::optional<std::int64_t> collisions, std::optional<double> until) {
  constexpr std::int64_t most = 1 << 20;  // 50 MB; what is larger grows as it comes
  if (collisions) {
    rows_.reserve(rows_.size() +
                  static_cast<std::size_t>(std::clamp<std::int64_t>(*collisions, 0, most)));
  }
  go_on(collisions, until, &rows_);
  return owning_rows(std::exchange(rows_, {}));
}

void DrivenRun::skip(std::optional<std::int64_t> collisions, std::optional<double> until) {
  go_on(collisions, until, nullptr);
  rows_.clear();  // of an advance that was interrupted
}

void DrivenRun::save() {
  const Use use(*this);
  require_open();
  if (!has_output_) {
    throw InputError(
        "save: the run has no output (nothing is kept); start it with output=\"OUT.h5\"");
  }
  attempt([&] { run_->save(); });
}

std::string DrivenRun::finish() {
  const Use use(*this);
  if (end_) return *end_;
  require_open();
  attempt([&] { end_ = to_json(run_->finish(), values_.system.dimension); });
  look();
  return *end_;
}

std::string DrivenRun::summary() const {
  const Use use(*this);
  return end_ ? *end_ : to_json(run_->summary(), values_.system.dimension);
}

py::tuple DrivenRun::state() const {
  const Use use(*this);
  SphereState state = run_->state();
  const py::ssize_t dimension = values_.system.dimension;
  Snapshot& snapshot = state.snapshot;
  return py::make_tuple(snapshot.step, snapshot.time,
                        owning_table(std::move(snapshot.positions), dimension),
                        owning_table(std::move(snapshot.velocities), dimension),
                        owning_table(std::move(state.peculiar_velocities), dimension),
                        owning_table(std::move(snapshot.box_edges), dimension),
                        owning_images(std::move(snapshot.images), dimension),
                        owning_spins(std::move(snapshot.angular_velocities), dimension));
}

}  // namespace zenosphere
