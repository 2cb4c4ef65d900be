#include "run/recorder.hpp"

#include "model/instantiate.hpp"
#include "run/snapshot_of.hpp"

namespace zenosphere {

template <int Dim, class Real>
Recorder<Dim, Real>::Recorder(const Case& values, const Simulation<Dim, Real>& simulation,
                              OutputFile& file)
    : output_(values.output),
      log_(values.collapse.gap_threshold.template in<Real>(), simulation.box().clock_unit()),
      file_(file) {
  take_snapshot(simulation);
}

template <int Dim, class Real>
Recorder<Dim, Real>::Recorder(const Case& values, const Simulation<Dim, Real>& simulation,
                              OutputFile& file, ArchiveReader& archive)
    : output_(values.output),
      log_(values.collapse.gap_threshold.template in<Real>(), simulation.box().clock_unit()),
      file_(file) {
  archive_members(*this, archive);
  schedule_snapshot();
  if (!output_.snapshot_interval) return;
  require_archived(!simulation.has_reached(next_snapshot_ + *output_.snapshot_interval),
                   "snapshots that were not taken");
}

template <int Dim, class Real>
void Recorder<Dim, Real>::observe(const Collision<Dim, Real>& collision) {
  if (output_.collision_log == CollisionLog::none) return;
  observe_next(collision.gap_before);
  if (waiting_) append(*waiting_);
  log_.write(collision, waiting_.emplace());
}

template <int Dim, class Real>
void Recorder<Dim, Real>::observe_next(const Real& gap) {
  if (waiting_) log_.complete(*waiting_, gap);
}

template <int Dim, class Real>
void Recorder<Dim, Real>::append(const CollisionRow& row) {
  const bool is_windowed = output_.collision_log == CollisionLog::window;
  if (is_windowed && row.k < output_.log_first) return;
  if (is_windowed && output_.log_last && row.k > *output_.log_last) return;
  file_.append(row);
}

template <int Dim, class Real>
void Recorder<Dim, Real>::take_snapshot(const Simulation<Dim, Real>& simulation) {
  file_.write(snapshot_of(simulation));
  last_snapshot_time_ = simulation.time();
  last_snapshot_step_ = simulation.collisions();
  if (!output_.snapshot_interval) return;
  while (simulation.has_reached(static_cast<double>(snapshots_) * *output_.snapshot_interval)) {
    ++snapshots_;
  }
  schedule_snapshot();
}

/// Multiples of the interval, so that the times do not drift by rounding.
template <int Dim, class Real>
void Recorder<Dim, Real>::schedule_snapshot() {
  if (!output_.snapshot_interval) return;
  next_snapshot_ = static_cast<double>(snapshots_) * *output_.snapshot_interval;
}

template <int Dim, class Real>
void Recorder<Dim, Real>::finish(const Simulation<Dim, Real>& simulation) {
  if (waiting_) append(*waiting_);
  waiting_.reset();
  const bool is_new =
      simulation.time() != last_snapshot_time_ || simulation.collisions() != last_snapshot_step_;
  if (is_new) file_.write(snapshot_of(simulation));
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class Recorder<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
