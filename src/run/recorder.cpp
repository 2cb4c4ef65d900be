#include "run/recorder.hpp"

#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim, class Real>
Recorder<Dim, Real>::Recorder(const Case& values, const Simulation<Dim, Real>& simulation,
                              OutputFile& file)
    : output_(values.output),
      gap_threshold_(values.collapse.gap_threshold),
      clock_unit_(simulation.box().clock_unit()),
      file_(file) {
  take_snapshot(simulation);
}

template <int Dim, class Real>
Recorder<Dim, Real>::Recorder(const Case& values, const Simulation<Dim, Real>& simulation,
                              OutputFile& file, ArchiveReader& archive)
    : output_(values.output),
      gap_threshold_(values.collapse.gap_threshold),
      clock_unit_(simulation.box().clock_unit()),
      file_(file) {
  archive_members(*this, archive);
  schedule_snapshot();
}

template <int Dim, class Real>
void Recorder<Dim, Real>::observe(const Collision<Dim, Real>& collision) {
  if (output_.collision_log == CollisionLog::none) return;
  observe_next(collision.gap_before);
  if (waiting_) append(*waiting_);
  waiting_ = CollisionRow{
      .k = collision.number,
      .time = since_start(collision.time, clock_unit_),
      .i = collision.i,
      .j = collision.j,
      .gap = std::numeric_limits<double>::quiet_NaN(),
      .normal_speed = static_cast<double>(collision.impact.normal_speed),
      .flags = 0,
  };
  if (collision.overlapping) waiting_->flags |= collision_flag::overlap;
  if (collision.absorbed) waiting_->flags |= collision_flag::absorbed;
  if (!(collision.impact.normal_speed > 0)) waiting_->flags |= collision_flag::receding;
  if (collision.made_elastic) waiting_->flags |= collision_flag::made_elastic;
  if (!(collision.flight > 0)) waiting_->flags |= collision_flag::clock_stood;
}

template <int Dim, class Real>
void Recorder<Dim, Real>::observe_next(const Real& gap) {
  if (!waiting_) return;
  waiting_->gap = static_cast<double>(gap);
  if (gap <= gap_threshold_) waiting_->flags |= collision_flag::hit;
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
  file_.write(snapshot(simulation));
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
  if (is_new) file_.write(snapshot(simulation));
}

template <int Dim, class Real>
Snapshot Recorder<Dim, Real>::snapshot(const Simulation<Dim, Real>& simulation) const {
  const auto& box = simulation.box();
  Snapshot snapshot{.step = simulation.collisions(),
                    .time = simulation.time(),
                    .positions = {},
                    .velocities = {},
                    .box_edges = std::vector<double>(Dim * Dim, 0.0)};
  for (int axis = 0; axis < Dim; ++axis) {
    snapshot.box_edges[static_cast<std::size_t>(axis * (Dim + 1))] =
        static_cast<double>(box.sides()[axis]);
  }
  if constexpr (Dim > 1) {
    snapshot.box_edges[Dim] = static_cast<double>(simulation.lees_edwards_offset());
  }
  const Configuration<Dim, Real> state = simulation.configuration();
  for (std::size_t i = 0; i < state.positions.size(); ++i) {
    auto velocity = state.velocities[i];
    velocity[0] += box.profile(state.positions[i]);
    for (int axis = 0; axis < Dim; ++axis) {
      snapshot.positions.push_back(static_cast<double>(state.positions[i][axis]));
      snapshot.velocities.push_back(static_cast<double>(velocity[axis]));
    }
  }
  return snapshot;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class Recorder<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
