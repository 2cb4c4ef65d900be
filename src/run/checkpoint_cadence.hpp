#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "case/case.hpp"

namespace zenosphere {

/// When a run makes its next checkpoint: after some wall time, and after some collisions.
///
/// By the clock a checkpoint comes no sooner than fifty times as long as the last one took, so that
/// checkpoints cost at most two per cent of a run. Those that the case asks for by collisions come
/// whatever they cost.
class CheckpointCadence {
 public:
  /// \param collisions  done when the run begins or goes on
  CheckpointCadence(const Case::Output& output, std::int64_t collisions)
      : interval_(output.checkpoint_seconds),
        collisions_between_(output.checkpoint_collisions.value_or(0)),
        next_seconds_(interval_) {
    schedule(collisions);
  }

  bool is_due_after(std::int64_t collisions) const { return collisions >= next_collisions_; }
  /// Collisions after which the next one is due, whatever the clock says.
  std::int64_t next_collisions() const { return next_collisions_; }
  bool is_due_at(double seconds) const { return seconds >= next_seconds_; }

  /// Notes a checkpoint.
  ///
  /// \param begun, done  wall time since the run began or went on [s]
  void note(double begun, double done, std::int64_t collisions) {
    next_seconds_ = done + std::max(interval_, 50 * (done - begun));
    schedule(collisions);
  }

 private:
  /// At multiples, so that a run that was interrupted makes them at the same collisions.
  void schedule(std::int64_t collisions) {
    if (collisions_between_ == 0) return;
    next_collisions_ = (collisions / collisions_between_ + 1) * collisions_between_;
  }

  double interval_;
  std::int64_t collisions_between_;
  double next_seconds_;
  std::int64_t next_collisions_ = std::numeric_limits<std::int64_t>::max();
};

}  // namespace zenosphere
