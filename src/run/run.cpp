#include "run/run.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "collapse/arrest_criterion.hpp"
#include "collapse/collapse_time.hpp"
#include "collapse/separation_criterion.hpp"
#include "collapse/verdict.hpp"
#include "flow/measurements.hpp"
#include "io/case_file.hpp"
#include "io/derived.hpp"
#include "model/real.hpp"
#include "run/random_driving.hpp"
#include "run/recorder.hpp"
#include "run/setup.hpp"
#include "run/stopwatch.hpp"

namespace zenosphere {

namespace {

std::vector<std::string> boundary_words(int dimension, std::optional<int> closed_axis) {
  std::vector<std::string> words(static_cast<std::size_t>(dimension), "periodic");
  if (closed_axis) words[static_cast<std::size_t>(*closed_axis)] = "none";
  return words;
}

/// One run: the simulation and everything that observes it.
template <int Dim, class Real>
class Run {
 public:
  Run(const Case& values, const RunOptions& options)
      : values_(values),
        options_(options),
        box_(box_of<Dim, Real>(values)),
        simulation_(box_, start_of<Dim, Real>(values, box_),
                    {from_decimal<Real>(values.system.restitution), values.collision.overlap,
                     from_decimal<Real>(values.collision.guard)},
                    surroundings_of<Dim, Real>(values)),
        driving_(values),
        separation_(values.collapse.gap_threshold, box_.clock_unit()),
        arrest_(values.collapse.gap_threshold, values.collapse.window, box_.clock_unit()),
        collapse_time_(box_.clock_unit()),
        measurements_(simulation_, values.measure.after_time) {
    if (!options.output) return;
    file_.emplace(*options.output,
                  OutputFile::Header{values.text, resolved_toml(values), Dim, values.system.spheres,
                                     boundary_words(Dim, box_.closed_axis())},
                  options.existing);
    recorder_.emplace(values, simulation_, *file_);
    file_->flush();  // whatever happens now, the start is kept
  }

  Summary go() {
    while (!is_over()) {
      if (const auto collision = simulation_.next_collision(next_pause())) {
        separation_.observe(*collision);
        arrest_.observe(*collision);
        collapse_time_.observe(*collision);
        measurements_.observe(*collision, simulation_);
        if (recorder_) recorder_->observe(*collision);
        absorbed_ += collision->absorbed;
        overlapping_ += collision->overlapping;
        receding_ += !(collision->impact.normal_speed > 0);
      } else {
        pause();
      }
      attend_to_the_clock();
    }
    if (const auto& pair = simulation_.stopped_before()) {
      separation_.observe_next(pair->gap);
      if (recorder_) recorder_->observe_next(pair->gap);
    }
    Summary result = summary();
    if (recorder_) recorder_->finish(simulation_);
    if (file_) file_->finish(result);
    return result;
  }

 private:
  /// Sets why the run ends, once it does.
  bool is_over() {
    const auto& limits = values_.run;
    if (options_.interrupt && *options_.interrupt) {
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
    if (simulation_.is_at_rest()) simulation_.rest_until(next_pause());
    if (recorder_ && simulation_.has_reached(recorder_->next_snapshot())) {
      recorder_->take_snapshot(simulation_);
    }
    if (simulation_.has_reached(driving_.next_kick())) driving_.kick(simulation_, measurements_);
  }

  /// Now and then shows the progress, and makes sure that a killed run loses little.
  void attend_to_the_clock() {
    constexpr unsigned kCallsBetween = 4096;  // some ms: asking for the time is not free
    if (++calls_ % kCallsBetween != 0) return;
    const double seconds = stopwatch_.seconds();
    if (options_.on_progress && seconds >= next_report_) {
      next_report_ = seconds + 0.2;
      options_.on_progress(progress());
    }
    if (file_ && seconds >= next_flush_) {
      next_flush_ = seconds + 30;
      file_->flush();
    }
  }

  Progress progress() const {
    Progress progress{.collisions = simulation_.collisions(),
                      .time = simulation_.time(),
                      .collisions_per_second =
                          static_cast<double>(simulation_.collisions()) / stopwatch_.seconds(),
                      .separation_hits = separation_.hits(),
                      .done = 0,
                      .wall_seconds = stopwatch_.seconds()};
    if (const auto& limit = values_.run.collisions) {
      if (*limit > 0) {
        progress.done = static_cast<double>(progress.collisions) / static_cast<double>(*limit);
      }
    }
    if (const auto& limit = values_.run.time) {
      if (*limit > 0) progress.done = std::max(progress.done, progress.time / *limit);
    }
    return progress;
  }

  Summary summary() const {
    Summary summary;
    summary.collisions = simulation_.collisions();
    summary.collisions_per_sphere =
        2 * static_cast<double>(summary.collisions) / static_cast<double>(simulation_.spheres());
    summary.time = simulation_.time();
    summary.strain = static_cast<double>(box_.shear_rate()) * summary.time;
    summary.ended_by = ended_by_;
    summary.outcome = ended_by_ == "signal"   ? "interrupted"
                      : ended_by_ == "arrest" ? "collapsed"
                                              : "finished";
    add_collapse(summary);
    summary.absorbed = absorbed_;
    summary.overlap_collisions = overlapping_;
    summary.overlaps_ignored = simulation_.overlaps_ignored();
    summary.receding = receding_;
    summary.averages = measurements_.averages(simulation_);
    summary.ledger_error = measurements_.ledger_error(simulation_);
    summary.wall_seconds = stopwatch_.seconds();
    summary.collisions_per_second = static_cast<double>(summary.collisions) / summary.wall_seconds;
    summary.peak_memory_bytes = peak_memory_bytes();
    return summary;
  }

  void add_collapse(Summary& summary) const {
    summary.verdict = word(verdict(summary.collisions, separation_.last_collision(),
                                   arrest_.is_met(), arrest_.window()));
    summary.separation = {separation_.hits(), separation_.first_collision(),
                          separation_.first_time(), separation_.last_collision()};
    summary.arrest = {
        arrest_.is_met(),      arrest_.collision(),   arrest_.time(), arrest_.window(), {},
        collapse_time_.time(), collapse_time_.ratio()};
    for (const auto& [i, j] : arrest_.pairs()) summary.arrest.pairs.emplace_back(i, j);
  }

  static std::int64_t peak_memory_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss * 1024;
  }

  Case values_;
  RunOptions options_;
  ShearBox<Dim, Real> box_;
  Simulation<Dim, Real> simulation_;
  RandomDriving<Dim, Real> driving_;
  SeparationCriterion<Dim, Real> separation_;
  ArrestCriterion<Dim, Real> arrest_;
  CollapseTime<Dim, Real> collapse_time_;
  Measurements<Dim, Real> measurements_;
  std::optional<OutputFile> file_;
  std::optional<Recorder<Dim, Real>> recorder_;
  Stopwatch stopwatch_;
  std::int64_t absorbed_ = 0;
  std::int64_t overlapping_ = 0;
  std::int64_t receding_ = 0;
  std::string ended_by_;
  unsigned calls_ = 0;
  double next_report_ = 0;
  double next_flush_ = 30;
};

template <class Real>
Summary run_in(const Case& values, const RunOptions& options) {
  switch (values.system.dimension) {
    case 1:
      return Run<1, Real>(values, options).go();
    case 2:
      return Run<2, Real>(values, options).go();
    default:
      return Run<3, Real>(values, options).go();
  }
}

}  // namespace

Summary run_case(const Case& values, const RunOptions& options) {
  if (options.output) OutputFile::check_target(*options.output, options.existing);
  switch (values.collision.precision) {
    case Precision::extended:
      return run_in<Extended>(values, options);
    case Precision::quad:
      return run_in<Quad>(values, options);
    case Precision::digits100:
      return run_in<Digits100>(values, options);
    case Precision::double_precision:
      break;
  }
  return run_in<double>(values, options);
}

}  // namespace zenosphere
