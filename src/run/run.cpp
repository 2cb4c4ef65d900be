#include "run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "collapse/arrest_criterion.hpp"
#include "collapse/collapse_time.hpp"
#include "collapse/dissector.hpp"
#include "collapse/separation_criterion.hpp"
#include "collapse/verdict.hpp"
#include "flow/measurements.hpp"
#include "io/case_file.hpp"
#include "io/derived.hpp"
#include "model/errors.hpp"
#include "run/arithmetic.hpp"
#include "run/checkpoint_cadence.hpp"
#include "run/collision_counts.hpp"
#include "run/random_driving.hpp"
#include "run/recorder.hpp"
#include "run/self_check.hpp"
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
    archive_observers(*this, state);
    file_.emplace(std::move(output));
    recorder_.emplace(values, simulation_, *file_, state);
    state.require_end();
    file_->go_on(resolved_toml(values));
  }

  Run(const Case& values, const RunOptions& options, Simulation<Dim, Real> simulation)
      : values_(values),
        options_(options),
        box_(simulation.box()),
        simulation_(std::move(simulation)),
        driving_(values),
        separation_(values.collapse.gap_threshold, box_.clock_unit()),
        arrest_(values.collapse.gap_threshold, values.collapse.window, box_.clock_unit()),
        collapse_time_(box_.clock_unit()),
        dissector_(values.collapse.gap_threshold, simulation_.spheres(), box_.clock_unit(),
                   constant_restitution(values)),
        measurements_(simulation_, values.measure.after_time),
        self_check_(simulation_),
        cadence_(values.output, simulation_.collisions()) {}

  Summary go() {
    while (!is_over()) {
      if (const auto collision = simulation_.collision_until(next_pause())) {
        separation_.observe(*collision);
        arrest_.observe(*collision);
        collapse_time_.observe(*collision);
        dissector_.observe(*collision);
        if (arrest_.is_met()) dissector_.observe_arrest(arrest_.pairs());
        measurements_.observe(*collision, simulation_);
        self_check_.observe(*collision);
        if (recorder_) recorder_->observe(*collision);
        counts_.observe(*collision);
      } else if (simulation_.is_waiting()) {
        pause();
      }
      if (self_check_.is_due(simulation_)) self_check_.look(simulation_, measurements_);
      attend_to_the_clock();
    }
    return finish();
  }

 private:
  Summary finish() {
    keep_the_end();
    self_check_.look(simulation_, measurements_);  // a longer run would not look here
    if (self_check_.violation()) ended_by_ = "self-check";
    if (const auto& pair = simulation_.stopped_before()) {
      separation_.observe_next(pair->gap);
      dissector_.observe_next({pair->i, pair->j}, pair->gap);
      if (recorder_) recorder_->observe_next(pair->gap);
    }
    Summary result = summary();
    if (recorder_) recorder_->finish(simulation_);
    if (file_) file_->finish(result, dissector_.anatomy());
    return result;
  }

  /// Sets why the run ends, once it does.
  bool is_over() {
    const auto& limits = values_.run;
    if (self_check_.violation()) {
      ended_by_ = "self-check";
    } else if (options_.interrupt && *options_.interrupt) {
      ended_by_ = "signal";
    } else if (arrest_.is_met() && values_.collapse.stop_when_collapsed) {
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
    if (simulation_.has_reached(driving_.next_kick())) driving_.kick(simulation_, measurements_);
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
    archive_observers(*this, archive);
    recorder_->archive_to(archive);
    return {.collisions = simulation_.collisions(),
            .time = simulation_.time(),
            .clock_units = simulation_.now().units,
            .clock_remainder = static_cast<double>(simulation_.now().remainder),
            .wall_seconds = wall_seconds(),
            .summary = to_json(summary(), Dim),
            .state = archive.release()};
  }

  template <class Self, class Archive>
  static void archive_observers(Self& self, Archive& archive) {
    archive(self.driving_, self.separation_, self.arrest_, self.collapse_time_, self.dissector_,
            self.measurements_, self.counts_, self.self_check_);
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
            .separation_hits = separation_.hits(),
            .done = std::max(part(done, values_.run.collisions),
                             part(simulation_.time(), values_.run.time)),
            .wall_seconds = wall_seconds()};
  }

  Summary summary() const {
    Summary summary;
    summary.collisions = simulation_.collisions();
    summary.collisions_per_sphere =
        2 * static_cast<double>(summary.collisions) / static_cast<double>(simulation_.spheres());
    summary.time = simulation_.time();
    summary.strain = static_cast<double>(box_.shear_rate()) * summary.time;
    summary.ended_by = ended_by_;
    const bool is_interrupted = ended_by_ == "signal" || ended_by_ == "self-check";
    summary.outcome = ended_by_.empty()       ? "unfinished"
                      : is_interrupted        ? "interrupted"
                      : ended_by_ == "arrest" ? "collapsed"
                                              : "finished";
    summary.self_check = self_check_.violation();
    add_collapse(summary);
    summary.absorbed = counts_.absorbed;
    summary.overlap_collisions = counts_.overlapping;
    summary.overlaps_ignored = simulation_.overlaps_ignored();
    summary.receding = counts_.receding;
    summary.contact = contact();
    summary.anatomy = in_short(dissector_.anatomy());
    summary.averages = measurements_.averages(simulation_);
    summary.ledger_error = measurements_.ledger_error(simulation_);
    summary.wall_seconds = wall_seconds();
    summary.collisions_per_second = static_cast<double>(summary.collisions) / summary.wall_seconds;
    summary.peak_memory_bytes = peak_memory_bytes();
    return summary;
  }

  Summary::Contact contact() const {
    const auto counts = simulation_.contact_counts();
    if (!counts) return {values_.system.restitution, 0, 0};
    Summary::Contact contact{std::nullopt, counts->made_elastic, counts->rotated};
    if (counts->collisions > 0) contact.mean_restitution = counts->mean_restitution;
    return contact;
  }

  void add_collapse(Summary& summary) const {
    summary.verdict = word(verdict(summary.collisions, separation_.last_collision(),
                                   arrest_.is_met(), arrest_.window()));
    summary.separation = {separation_.hits(), separation_.first_collision(),
                          in_double(separation_.first_time()), separation_.last_collision()};
    summary.arrest = {arrest_.is_met(),
                      arrest_.collision(),
                      arrest_.time(),
                      arrest_.window(),
                      {},
                      in_double(collapse_time_.time()),
                      in_double(collapse_time_.ratio())};
    for (const auto& [i, j] : arrest_.pairs()) summary.arrest.pairs.emplace_back(i, j);
  }

  static std::optional<double> in_double(const std::optional<Real>& number) {
    return number ? std::optional<double>(static_cast<double>(*number)) : std::nullopt;
  }

  Case values_;
  RunOptions options_;
  ShearBox<Dim, Real> box_;
  Simulation<Dim, Real> simulation_;
  RandomDriving<Dim, Real> driving_;
  SeparationCriterion<Dim, Real> separation_;
  ArrestCriterion<Dim, Real> arrest_;
  CollapseTime<Dim, Real> collapse_time_;
  Dissector<Dim, Real> dissector_;
  Measurements<Dim, Real> measurements_;
  SelfCheck<Dim, Real> self_check_;
  CheckpointCadence cadence_;
  std::optional<OutputFile> file_;
  std::optional<Recorder<Dim, Real>> recorder_;
  bool is_end_kept_ = false;
  Stopwatch stopwatch_;
  CollisionCounts counts_;
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
