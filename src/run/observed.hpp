#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "run/ending.hpp"
#include "run/log_rows.hpp"
#include "run/observed_simulation.hpp"
#include "run/observers.hpp"
#include "run/random_driving.hpp"
#include "run/recorded_series.hpp"
#include "run/recorder.hpp"
#include "run/setup.hpp"
#include "run/snapshot_of.hpp"
#include "run/state_head.hpp"

namespace zenosphere {

/// The simulation of a run in one dimension and precision (see ObservedSimulation).
template <int Dim, class Real>
class Observed final : public ObservedSimulation {
 public:
  Observed(const Case& values, const std::atomic<bool>* interrupt, Simulation<Dim, Real> simulation)
      : values_(values),
        interrupt_(interrupt),
        simulation_(std::move(simulation)),
        driving_(values),
        observers_(values, simulation_),
        rows_({values.collapse.gap_threshold.template in<Real>(), simulation_.box().clock_unit()}) {
  }

  Observed(const Case& values, const std::atomic<bool>* interrupt, ArchiveReader& state)
      : Observed(values, interrupt, archived_simulation<Dim, Real>(values, state)) {
    require_archived(simulation_.spheres() == values.system.spheres,
                     "the state of another number of spheres");
    state(driving_, observers_);
  }

  Halt go_on(const Stretch& stretch) override;  // in stretch.cpp

  std::optional<EndedBy> what_ends() const override {
    if (observers_.has_violation()) return EndedBy::self_check;
    if (interrupt_ && *interrupt_) return EndedBy::signal;
    if (observers_.has_arrested() && values_.collapse.stop_when_collapsed) return EndedBy::arrest;
    if (const auto end = end_of_collisions(simulation_, driving_)) return end;
    const auto& limit = values_.run.collisions;
    if (limit && simulation_.collisions() >= *limit) return EndedBy::collisions;
    return end_of_time(simulation_, values_);
  }

  double next_pause() const override {
    double next = std::min(last_moment(), driving_.next_kick());
    if (samples_) next = std::min(next, samples_->next());
    return recorder_ ? std::min(next, recorder_->next_snapshot()) : next;
  }

  void pause_at(double time, bool is_last) override {
    simulation_.wait_until(time);
    if (is_last) kick_if_due();
    if (recorder_ && simulation_.has_reached(recorder_->next_snapshot())) {
      recorder_->take_snapshot(simulation_);
    }
    if (samples_ && simulation_.has_reached(samples_->next())) samples_->take(simulation_);
    kick_if_due();
  }

  void close(double time) override {
    if (time > simulation_.time()) simulation_.wait_until(time);
    observers_.look(simulation_);  // a longer run would not look here
    if (const auto& pair = simulation_.stopped_before()) {
      observers_.observe_next(pair->i, pair->j, pair->gap);
      if (recorder_) recorder_->observe_next(pair->gap);
    }
    if (recorder_) recorder_->finish(simulation_);
  }

  void record_to(OutputFile& file) override {
    begin_samples();
    recorder_.emplace(values_, simulation_, file);
  }
  void record_to(OutputFile& file, ArchiveReader& state) override {
    begin_samples();
    if (samples_) state(*samples_);
    recorder_.emplace(values_, simulation_, file, state);
  }

  void begin_piece(std::vector<CollisionRow>* rows) override {
    rows_.begin(rows);
    observers_.measurements().prefetch_with(simulation_);
  }

  void end_piece(bool is_last) override {
    if (!is_last) rows_.pause();
    if (const auto& pair = simulation_.stopped_before()) rows_.observe_next(pair->gap);
  }

  double last_moment() const override { return zenosphere::last_moment<Real>(values_); }
  double end_of_clock() const override { return zenosphere::end_of_clock<Real>(); }
  std::int64_t collisions() const override { return simulation_.collisions(); }
  double time() const override { return simulation_.time(); }
  std::int64_t separation_hits() const override { return observers_.hits(); }
  const Anatomy& anatomy() const override { return observers_.anatomy(); }
  ObservableSeries series() const override { return observers_.measurements().series(simulation_); }
  RecordedSamples samples() const override {
    return samples_ ? recorded(*samples_) : RecordedSamples{};
  }

  void add_to(Summary& summary, double time) const override {
    tell_at(time, [&](const auto& simulation) { observers_.add_to(summary, simulation); });
  }

  SphereState state(double time) const override {
    SphereState state;
    tell_at(time, [&](const auto& simulation) {
      state = {snapshot_of(simulation), peculiar_velocities_of(simulation)};
    });
    return state;
  }

  void add_to(Checkpoint& checkpoint) const override {
    checkpoint.collisions = simulation_.collisions();
    checkpoint.time = simulation_.time();
    checkpoint.clock_units = simulation_.now().units;
    checkpoint.clock_remainder = static_cast<double>(simulation_.now().remainder);
    ArchiveWriter archive;
    write_state_head<Dim, Real>(archive);
    simulation_.archive_to(archive);
    archive(driving_, observers_);
    if (samples_) archive(*samples_);
    recorder_->archive_to(archive);
    checkpoint.state = archive.release();
  }

 private:
  /// A time, a little before the run's last moment, up to which the clock ends no run.
  double time_before_the_end() const { return (1 - 1e-9) * last_moment(); }

  /// Whether the collision just done may be the last one: else what_ends() has no answer, which
  /// takes longer to see. Right after a collision nothing rests, and none has waited for another.
  ///
  /// \param sure_time  time_before_the_end()
  bool may_end_with_a_collision(double sure_time) const {
    const auto& limit = values_.run.collisions;
    return observers_.has_violation() || (interrupt_ && *interrupt_) || observers_.has_arrested() ||
           (limit && simulation_.collisions() >= *limit) || !(simulation_.time() < sure_time);
  }

  void begin_samples() {
    const auto& measure = values_.measure;
    if (!measure.sampling_interval) return;
    const double from = measure.after_time.is_found() ? 0 : measure.after_time.time();
    const bool is_limited = values_.run.time.has_value();
    samples_.emplace(simulation_, SampleTimes{*measure.sampling_interval, from, is_limited});
  }

  void kick_if_due() {
    if (!simulation_.has_reached(driving_.next_kick())) return;
    driving_.kick(simulation_, observers_.measurements());
  }

  /// Calls `tell` with the simulation as it is at `time`: where that is later than the last event,
  /// with a copy whose clock has gone on.
  template <class Tell>
  void tell_at(double time, Tell tell) const {
    if (!(time > simulation_.time())) return tell(simulation_);
    Simulation<Dim, Real> copy = simulation_;
    copy.wait_until(time);
    tell(copy);
  }

  const Case& values_;
  const std::atomic<bool>* interrupt_;
  Simulation<Dim, Real> simulation_;
  RandomDriving<Dim, Real> driving_;
  Observers<Dim, Real> observers_;
  std::optional<Samples<Dim, Real>> samples_;  ///< where there is an output to keep them
  RowCollector<Dim, Real> rows_;               ///< for who drives the run
  std::optional<Recorder<Dim, Real>> recorder_;
};

}  // namespace zenosphere
