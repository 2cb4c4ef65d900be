#include "run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "io/case_file.hpp"
#include "io/derived.hpp"
#include "model/errors.hpp"
#include "run/arithmetic.hpp"
#include "run/checkpoint_cadence.hpp"
#include "run/observers.hpp"
#include "run/random_driving.hpp"
#include "run/recorder.hpp"
#include "run/setup.hpp"
#include "run/state_head.hpp"
#include "run/stopwatch.hpp"

namespace zenosphere {

namespace {

/// One run: the simulation and everything that observes it.
template <int Dim, class Real>
class Run {
 public:
  /// A run from its start.
  Run(const Case& values, const RunOptions& options)
      : Run(values, options, new_simulation<Dim, Real>(values)) {
    if (!options.output) return;
    file_.emplace(*options.output, output_header(values), options.existing);
    recorder_.emplace(values, simulation_, *file_);
    file_->begin(checkpoint());  // whatever happens now, the start is kept
  }

  /// A run that goes on from a checkpoint.
  Run(const Case& values, const RunOptions& options, RecoveredOutput output, ArchiveReader& state)
      : Run(values, options, archived_simulation<Dim, Real>(values, state)) {
    require_archived(simulation_.spheres() == values.system.spheres,
                     "the state of another number of spheres");
    earlier_seconds_ = output.checkpoint.wall_seconds;
    state(driving_, observers_);
    file_.emplace(std::move(output));
    recorder_.emplace(values, simulation_, *file_, state);
    state.require_end();
    file_->go_on(resolved_toml(values));
  }

  Run(const Case& values, const RunOptions& options, Simulation<Dim, Real> simulation)
      : values_(values),
        options_(options),
        simulation_(std::move(simulation)),
        driving_(values),
        observers_(values, simulation_),
        cadence_(values.output, simulation_.collisions()) {}

  Summary go() {
    while (!is_over()) {
      if (const auto collision = simulation_.collision_until(next_pause())) {
        observers_.observe(*collision, simulation_);
        if (recorder_) recorder_->observe(*collision);
      } else if (simulation_.is_waiting()) {
        pause();
      }
      attend_to_the_clock();
    }
    return finish();
  }

 private:
  Summary finish() {
    keep_the_end();
    observers_.look(simulation_);  // a longer run would not look here
    if (observers_.has_violation()) ended_by_ = "self-check";
    if (const auto& pair = simulation_.stopped_before()) {
      observers_.observe_next(pair->i, pair->j, pair->gap);
      if (recorder_) recorder_->observe_next(pair->gap);
    }
    Summary result = summary();
    if (recorder_) recorder_->finish(simulation_);
    if (file_) file_->finish(result, observers_.anatomy());
    return result;
  }

  /// Sets why the run ends, once it does.
  bool is_over() {
    const auto& limits = values_.run;
    if (observers_.has_violation()) {
      ended_by_ = "self-check";
    } else if (options_.interrupt && *options_.interrupt) {
      ended_by_ = "signal";
    } else if (observers_.has_arrested() && values_.collapse.stop_when_collapsed) {
      ended_by_ = "arrest";
    } else if (simulation_.stopped_before()) {
      ended_by_ = "overlap";
    } else if (simulation_.is_at_rest() && !driving_.is_on()) {
      ended_by_ = "at rest";
    } else if (limits.collisions && simulation_.collisions() >= *limits.collisions) {
      ended_by_ = "collisions";
    } else if (simulation_.has_reached(end_of_time())) {
      ended_by_ = "time";
    }
    return !ended_by_.empty();
  }

  /// Where the case sets none, the end of the clock: a gas that has all but stopped gets there.
  double end_of_time() const {
    return values_.run.time.value_or(std::numeric_limits<double>::max());
  }

  double next_pause() const {
    const double next = std::min(end_of_time(), driving_.next_kick());
    return recorder_ ? std::min(next, recorder_->next_snapshot()) : next;
  }

  /// Does what is due at this time without a collision.
  void pause() {
    const double until = next_pause();
    // A longer run does not stop the clock at the end of this one: from here it can go on.
    if (until >= end_of_time()) keep_the_end();
    simulation_.wait_until(until);
    if (recorder_ && simulation_.has_reached(recorder_->next_snapshot())) {
      recorder_->take_snapshot(simulation_);
    }
    if (simulation_.has_reached(driving_.next_kick()))
      driving_.kick(simulation_, observers_.measurements());
  }

  /// Now and then shows the progress, and makes sure that a killed run loses little.
  void attend_to_the_clock() {
    if (is_recording() && cadence_.is_due_after(simulation_.collisions())) save();
    constexpr unsigned kCallsBetween = 4096;  // some ms: asking for the time is not free
    if (++calls_ % kCallsBetween != 0) return;
    const double seconds = stopwatch_.seconds();
    if (options_.on_progress && seconds >= next_report_) {
      next_report_ = seconds + 0.2;
      options_.on_progress(progress());
    }
    if (file_ && seconds >= next_look_) {
      next_look_ = seconds + 1;
      file_->require_in_place();
    }
    if (is_recording() && cadence_.is_due_at(seconds)) save();
  }

  /// Keeps the state that a longer run would go through too; what is recorded from now on belongs
  /// to the end of this one.
  void keep_the_end() {
    if (is_recording()) file_->end(checkpoint());
    is_end_kept_ = true;
  }

  /// Whether checkpoints are to be made: there is a file, and its end is not kept yet.
  bool is_recording() const { return file_ && !is_end_kept_; }

  void save() {
    const double begun = stopwatch_.seconds();
    file_->checkpoint(checkpoint());
    cadence_.note(begun, stopwatch_.seconds(), simulation_.collisions());
    file_->fold_if_due();
  }

  Checkpoint checkpoint() const {
    ArchiveWriter archive;
    write_state_head<Dim, Real>(archive);
    simulation_.archive_to(archive);
    archive(driving_, observers_);
    recorder_->archive_to(archive);
    return {.collisions = simulation_.collisions(),
            .time = simulation_.time(),
            .clock_units = simulation_.now().units,
            .clock_remainder = static_cast<double>(simulation_.now().remainder),
            .wall_seconds = wall_seconds(),
            .summary = to_json(summary(), Dim),
            .state = archive.release()};
  }

  /// Wall time of the whole run, with what it took before it was interrupted [s].
  double wall_seconds() const { return earlier_seconds_ + stopwatch_.seconds(); }

  Progress progress() const {
    const auto part = [](double done, const auto& limit) {
      return limit && *limit > 0 ? done / static_cast<double>(*limit) : 0;
    };
    const std::int64_t collisions = simulation_.collisions();
    const auto done = static_cast<double>(collisions);
    return {.collisions = collisions,
            .time = simulation_.time(),
            .collisions_per_second = done / wall_seconds(),
            .separation_hits = observers_.hits(),
            .done = std::max(part(done, values_.run.collisions),
                             part(simulation_.time(), values_.run.time)),
            .wall_seconds = wall_seconds()};
  }

  Summary summary() const {
    Summary summary;
    observers_.add_to(summary, simulation_);
    summary.ended_by = ended_by_;
    const bool is_interrupted = ended_by_ == "signal" || ended_by_ == "self-check";
    summary.outcome = ended_by_.empty()       ? "unfinished"
                      : is_interrupted        ? "interrupted"
                      : ended_by_ == "arrest" ? "collapsed"
                                              : "finished";
    summary.wall_seconds = wall_seconds();
    summary.collisions_per_second = static_cast<double>(summary.collisions) / summary.wall_seconds;
    summary.peak_memory_bytes = peak_memory_bytes();
    return summary;
  }

  Case values_;
  RunOptions options_;
  Simulation<Dim, Real> simulation_;
  RandomDriving<Dim, Real> driving_;
  Observers<Dim, Real> observers_;
  CheckpointCadence cadence_;
  std::optional<OutputFile> file_;
  std::optional<Recorder<Dim, Real>> recorder_;
  bool is_end_kept_ = false;
  Stopwatch stopwatch_;
  std::string ended_by_;
  unsigned calls_ = 0;
  double next_report_ = 0, next_look_ = 1;  ///< by the stopwatch [s]
  double earlier_seconds_ = 0;              ///< wall time before the run was resumed
};

template <int Dim, class Real>
Summary go_on(const Case& values, RecoveredOutput output, const RunOptions& options) {
  const std::string name = output.path.string();
  std::optional<Run<Dim, Real>> run;
  try {
    const Bytes bytes = std::move(output.checkpoint.state);
    ArchiveReader state(bytes);
    require_known_state<Dim, Real>(values, output, state);
    run.emplace(values, options, std::move(output), state);
  } catch (const ArchiveError& error) {
    throw InputError(fmt::format("{}: has a checkpoint that is damaged ({}); run the case again",
                                 name, error.what()));
  }
  return run->go();
}

}  // namespace

Summary run_case(const Case& values, const RunOptions& options) {
  if (options.output) OutputFile::check_target(*options.output, options.existing);
  return in_arithmetic_of(
      values, [&]<int Dim, class Real>() { return Run<Dim, Real>(values, options).go(); });
}

Summary resume_case(const Case& values, RecoveredOutput output, const RunOptions& options) {
  return in_arithmetic_of(values, [&]<int Dim, class Real>() {
    return go_on<Dim, Real>(values, std::move(output), options);
  });
}

}  // namespace zenosphere
