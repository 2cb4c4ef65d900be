#pragma once

#include <cstdint>
#include <limits>
#include <utility>

#include "run/checkpoint_cadence.hpp"
#include "run/run_clock.hpp"
#include "storage/output_file.hpp"

namespace zenosphere {

/// The output of a run: its file, with checkpoints in time.
class RunOutput {
 public:
  /// \param collisions  done when the run begins or goes on
  /// \param arguments   of the OutputFile
  template <class... Arguments>
  RunOutput(const Case::Output& output, std::int64_t collisions, Arguments&&... arguments)
      : file_(std::forward<Arguments>(arguments)...), cadence_(output, collisions) {}

  OutputFile& file() { return file_; }

  /// Whether checkpoints are to be made: the end is not kept yet.
  bool is_recording() const { return !is_end_kept_; }

  bool is_due_after(std::int64_t collisions) const {
    return is_recording() && cadence_.is_due_after(collisions);
  }
  bool is_due_at(double seconds) const { return is_recording() && cadence_.is_due_at(seconds); }
  /// Collisions after which the next checkpoint is due, at the latest.
  std::int64_t next_collisions() const {
    return is_recording() ? cadence_.next_collisions() : std::numeric_limits<std::int64_t>::max();
  }

  /// Writes a checkpoint.
  ///
  /// \param make  gives it; what that takes counts
  template <class Make>
  void checkpoint(const RunClock& clock, Make make) {
    const double begun = clock.seconds();
    Checkpoint made = make();
    const std::int64_t collisions = made.collisions;
    file_.checkpoint(std::move(made));
    cadence_.note(begun, clock.seconds(), collisions);
    file_.fold_if_due();
  }

  /// Keeps the state that a longer run would go through too; what is recorded from now on belongs
  /// to the end of this one.
  void end(Checkpoint checkpoint) {
    file_.end(std::move(checkpoint));
    is_end_kept_ = true;
  }

  /// Looks, once a second, whether the file is still there.
  void look_at(double seconds) {
    if (seconds < next_look_) return;
    next_look_ = seconds + 1;
    file_.require_in_place();
  }

 private:
  OutputFile file_;
  CheckpointCadence cadence_;
  bool is_end_kept_ = false;
  double next_look_ = 1;  ///< [s]
};

}  // namespace zenosphere
