#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "case/case_file.hpp"
#include "collapse/verdict.hpp"
#include "run/checkpoint_cadence.hpp"
#include "run/ending.hpp"
#include "run/log_rows.hpp"
#include "run/observers.hpp"
#include "run/random_driving.hpp"
#include "run/recorded_series.hpp"
#include "run/recorder.hpp"
#include "run/setup.hpp"
#include "run/snapshot_of.hpp"
#include "run/species_summary.hpp"
#include "run/state_head.hpp"
#include "run/stepped_run.hpp"
#include "run/stopwatch.hpp"

namespace zenosphere {

/// One run: the simulation and everything that observes it. Compiled in stepped_run.cpp only.
template <int Dim, class Real>
class Run final : public SteppedRun {
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
    if (samples_) state(*samples_);
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
        rows_({values.collapse.gap_threshold.template in<Real>(), simulation_.box().clock_unit()}),
        cadence_(values.output, simulation_.collisions()) {
    const auto& measure = values.measure;
    if (!measure.sampling_interval) return;
    const double from = measure.after_time.is_found() ? 0 : measure.after_time.time();
    const bool is_limited = values.run.time.has_value();
    samples_.emplace(simulation_, SampleTimes{*measure.sampling_interval, from, is_limited});
  }

  void advance(const Piece& piece, std::vector<CollisionRow>* rows) override {
    begin(piece, rows);
    while (!is_ending() && !is_piece_done()) {
      if (const auto collision = simulation_.collision_until(next_stop())) {
        observers_.observe(*collision, simulation_);
        if (samples_) samples_->observe(*collision, simulation_);
        if (recorder_) recorder_->observe(*collision);
        rows_.observe(*collision);
      } else if (simulation_.is_waiting()) {
        pause();
      }
      attend_to_the_clock();
    }
    if (!is_over()) rows_.pause();
    if (const auto& pair = simulation_.stopped_before()) rows_.observe_next(pair->gap);
  }

  bool is_over() const override { return !ended_by_.empty(); }
  std::int64_t collisions() const override { return simulation_.collisions(); }
  double time() const override { return std::max(simulation_.time(), stopped_at_); }
  void save() override {
    if (is_recording()) checkpoint_now();
  }

  Summary summary() const override {
    return at_the_stop([&](const auto& simulation) { return summary_at(simulation); });
  }

  SphereState state() const override {
    return at_the_stop([](const auto& simulation) {
      return SphereState{snapshot_of(simulation), peculiar_velocities_of(simulation)};
    });
  }

  Summary finish() override {
    if (!is_over()) ended_by_ = "signal";
    keep_the_end();
    if (stopped_at_ > simulation_.time()) simulation_.wait_until(stopped_at_);
    observers_.look(simulation_);  // a longer run would not look here
    if (observers_.has_violation()) ended_by_ = "self-check";
    if (const auto& pair = simulation_.stopped_before()) {
      observers_.observe_next(pair->i, pair->j, pair->gap);
      if (recorder_) recorder_->observe_next(pair->gap);
    }
    Summary result = summary_at(simulation_);
    if (recorder_) recorder_->finish(simulation_);
    if (file_) file_->finish(result, observers_.anatomy(), series_now(), samples_now());
    return result;
  }

 private:
  /// Sets where the piece ends, and who gets its rows.
  void begin(const Piece& piece, std::vector<CollisionRow>* rows) {
    constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
    const std::int64_t done = simulation_.collisions();
    last_collision_ = piece.collisions < most - done ? done + piece.collisions : most;
    last_time_ = piece.time;
    last_second_ = stopwatch_.seconds() + piece.seconds;
    is_stopped_ = false;
    rows_.begin(rows);
    observers_.measurements().fetch_with(simulation_);
  }

  bool is_piece_done() const { return is_stopped_ || simulation_.collisions() >= last_collision_; }

  /// Sets why the run ends, once it does.
  bool is_ending() {
    const auto& limits = values_.run;
    if (observers_.has_violation()) {
      ended_by_ = "self-check";
    } else if (options_.interrupt && *options_.interrupt) {
      ended_by_ = "signal";
    } else if (observers_.has_arrested() && values_.collapse.stop_when_collapsed) {
      ended_by_ = "arrest";
    } else if (const char* end = end_of_collisions(simulation_, driving_)) {
      ended_by_ = end;
    } else if (limits.collisions && simulation_.collisions() >= *limits.collisions) {
      ended_by_ = "collisions";
    } else if (const char* late = end_of_time(simulation_, values_)) {
      ended_by_ = late;
    }
    return is_over();
  }

  double next_pause() const {
    double next = std::min(last_moment<Real>(values_), driving_.next_kick());
    if (samples_) next = std::min(next, samples_->next());
    return recorder_ ? std::min(next, recorder_->next_snapshot()) : next;
  }

  /// Where the engine is to stop if there is no collision before.
  double next_stop() const { return std::min(next_pause(), last_time_); }

  /// Does what is due at this time without a collision. The end of a piece is only noted: there
  /// the clock stays where it is.
  void pause() {
    const double until = next_pause();
    if (last_time_ < until) {
      is_stopped_ = true;
      stopped_at_ = std::max(stopped_at_, last_time_);
      return;
    }
    // A longer run does not stop the clock at the end of this one: from here it can go on.
    const bool is_end = until >= last_moment<Real>(values_);
    if (is_end) keep_the_end();
    if (until >= end_of_clock<Real>()) {
      ended_by_ = "clock";
      return;
    }
    simulation_.wait_until(until);
    if (is_end) kick_if_due();  // the last snapshot is of what the summary tells
    if (recorder_ && simulation_.has_reached(recorder_->next_snapshot())) {
      recorder_->take_snapshot(simulation_);
    }
    if (samples_ && simulation_.has_reached(samples_->next())) samples_->take(simulation_);
    kick_if_due();
  }

  void kick_if_due() {
    if (!simulation_.has_reached(driving_.next_kick())) return;
    driving_.kick(simulation_, observers_.measurements());
  }

  /// Now and then shows the progress, and makes sure that a killed run loses little.
  void attend_to_the_clock() {
    if (is_recording() && cadence_.is_due_after(simulation_.collisions())) checkpoint_now();
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
    if (is_recording() && cadence_.is_due_at(seconds)) checkpoint_now();
    if (seconds >= last_second_) is_stopped_ = true;
  }

  /// Keeps the state that a longer run would go through too; what is recorded from now on belongs
  /// to the end of this one.
  void keep_the_end() {
    if (is_recording()) file_->end(checkpoint());
    is_end_kept_ = true;
  }

  /// Whether checkpoints are to be made: there is a file, and its end is not kept yet.
  bool is_recording() const { return file_ && !is_end_kept_; }

  void checkpoint_now() {
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
    if (samples_) archive(*samples_);
    recorder_->archive_to(archive);
    return {.collisions = simulation_.collisions(),
            .time = simulation_.time(),
            .clock_units = simulation_.now().units,
            .clock_remainder = static_cast<double>(simulation_.now().remainder),
            .wall_seconds = wall_seconds(),
            .summary = to_json(summary_at(simulation_), Dim),
            .series = series_now(),
            .samples = samples_now(),
            .state = archive.release()};
  }

  RecordedSeries series_now() const {
    return recorded(observers_.measurements().series(simulation_), Dim);
  }

  RecordedSamples samples_now() const { return samples_ ? recorded(*samples_) : RecordedSamples{}; }

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

  /// Calls `tell` with the simulation as it is at the end of the last piece: where nothing happens
  /// up to there, that is a copy whose clock has gone on.
  template <class Tell>
  auto at_the_stop(Tell tell) const {
    if (!(stopped_at_ > simulation_.time())) return tell(simulation_);
    Simulation<Dim, Real> copy = simulation_;
    copy.wait_until(stopped_at_);
    return tell(copy);
  }

  Summary summary_at(const Simulation<Dim, Real>& simulation) const {
    Summary summary;
    observers_.add_to(summary, simulation);
    summary.species = species_summary(values_, summary.averages);
    summary.ended_by = ended_by_;
    summary.verdict = word(verdict(course_of(summary)));
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
  std::optional<Samples<Dim, Real>> samples_;
  RowCollector<Dim, Real> rows_;     ///< for who drives the run
  std::int64_t last_collision_ = 0;  ///< of the piece; likewise
  double last_time_ = 0, last_second_ = 0;
  double stopped_at_ = 0;    ///< the latest end of a piece that came before the next event
  bool is_stopped_ = false;  ///< the piece has ended by the clock
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

}  // namespace zenosphere
