#include "run/recorder.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

#include "flow/intervals_to_next.hpp"
#include "model/instantiate.hpp"
#include "run/snapshot_of.hpp"

namespace zenosphere {
template <int Dim, class Real>
Recorder<Dim, Real>::Recorder(const Case& values, const Simulation<Dim, Real>& simulation,
                              OutputFile& file)
    : output_(values.output),
      clock_is_limited_(values.run.time.has_value()),
      log_(values.collapse.gap_threshold.template in<Real>(), simulation.box().clock_unit()),
      file_(file) {
  take_snapshot(simulation);
}

template <int Dim, class Real>
Recorder<Dim, Real>::Recorder(const Case& values, const Simulation<Dim, Real>& simulation,
                              OutputFile& file, ArchiveReader& archive)
    : output_(values.output),
      clock_is_limited_(values.run.time.has_value()),
      log_(values.collapse.gap_threshold.template in<Real>(), simulation.box().clock_unit()),
      file_(file) {
  archive_members(*this, archive);
  schedule_snapshot();
  if (!output_.snapshot_interval) return;
  require_archived(!simulation.has_reached(time_of(snapshots_ + 1)),
                   "snapshots that were not taken");
}

template <int Dim, class Real>
void Recorder<Dim, Real>::take_snapshot(const Simulation<Dim, Real>& simulation) {
  file_.write(snapshot_of(simulation));
  last_snapshot_time_ = simulation.time();
  last_snapshot_step_ = simulation.collisions();
  schedule_snapshot();
  while (simulation.has_reached(next_snapshot_)) schedule_next();
}

template <int Dim, class Real>
void Recorder<Dim, Real>::schedule_next() {
  const bool is_bounded =
      clock_is_limited_ || output_.snapshot_spacing == SnapshotSpacing::logarithmic;
  snapshots_ += is_bounded ? 1 : intervals_to_next(snapshots_);
  schedule_snapshot();
}

template <int Dim, class Real>
void Recorder<Dim, Real>::schedule_snapshot() {
  next_snapshot_ = time_of(snapshots_);
}

/// Time of regular snapshot `n`, from 0: multiples of the interval, so that the times do not drift
/// by rounding; or, spaced logarithmically, the interval times a power of 10^(1/10).
template <int Dim, class Real>
double Recorder<Dim, Real>::time_of(std::int64_t n) const {
  constexpr double never = std::numeric_limits<double>::infinity();
  constexpr auto most = static_cast<double>(std::int64_t{1} << 53);  // multiples are exact up to it
  const auto multiple = static_cast<double>(n);
  if (!output_.snapshot_interval || multiple >= most) return never;
  if (output_.snapshot_spacing == SnapshotSpacing::linear || n == 0) {
    return multiple * *output_.snapshot_interval;
  }
  constexpr double in_a_decade = 10;
  return *output_.snapshot_interval * std::pow(10, (multiple - 1) / in_a_decade);
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
