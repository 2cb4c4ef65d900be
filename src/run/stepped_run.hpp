#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "case/case.hpp"
#include "result/summary.hpp"
#include "run/observed_simulation.hpp"
#include "run/run.hpp"
#include "run/run_clock.hpp"
#include "run/run_output.hpp"
#include "storage/recovery.hpp"

namespace zenosphere {

/// Where a piece of a run ends; what comes first counts. A limit of the case ends it too.
struct Piece {
  std::int64_t collisions = std::numeric_limits<std::int64_t>::max();  ///< at most so many more
  double time = std::numeric_limits<double>::infinity();               ///< since the start
  double seconds = std::numeric_limits<double>::infinity();            ///< of wall time, roughly
};

/// A run, which can be driven from outside piece by piece: its loop, where its pieces and the run
/// itself end, and what it writes.
///
/// A run in pieces gives the same bits as one that goes through, in its summary and its output:
/// between two pieces the clock stands at an event, and what is asked for in between is told by a
/// copy. Not to be used by two threads at once.
class SteppedRun {
 public:
  /// A run from its start.
  SteppedRun(const Case& values, const RunOptions& options);
  /// A run that goes on from a checkpoint.
  SteppedRun(const Case& values, RecoveredOutput output, const RunOptions& options);
  SteppedRun(const SteppedRun&) = delete;
  SteppedRun& operator=(const SteppedRun&) = delete;

  /// Goes on to the end of the piece or of the run.
  ///
  /// \param rows  the collisions of the piece are appended to it; null: they are not wanted. The
  ///              last one waits for the gap of the next pair and comes first in the next piece;
  ///              at the end of the run it comes at once
  /// Throws OutputError where the file cannot be written; then the run can only be destroyed.
  void advance(const Piece& piece, std::vector<CollisionRow>* rows);

  /// Whether a limit of the case, or what else ends a run, has been reached.
  bool is_over() const { return ended_by_.has_value(); }

  std::int64_t collisions() const { return simulation_->collisions(); }
  double time() const;  ///< the end of the last piece, where nothing happened before it

  /// What the run came to so far; its outcome is "unfinished" until it is over.
  Summary summary() const;
  SphereState state() const;

  /// Makes sure that the run can be resumed from here, where it has an output.
  void save();

  /// Ends the run, here if it is not over: writes what is left to write. The last call that may
  /// change anything.
  Summary finish();

 private:
  void go_on_from(RecoveredOutput output);
  void begin(const Piece& piece, std::vector<CollisionRow>* rows);
  bool is_piece_done() const;
  bool is_ending();
  Stretch next_stretch() const;
  void pause();
  void attend_to_the_clock(int rounds);
  void keep_the_end();
  void checkpoint_now();
  Checkpoint checkpoint() const;
  RecordedSeries series() const;
  Summary summary_at(double time) const;
  Progress progress() const;

  Case values_;
  RunOptions options_;
  RunClock clock_;
  std::optional<RunOutput> output_;
  std::unique_ptr<ObservedSimulation> simulation_;  ///< which writes into the output
  std::optional<EndedBy> ended_by_;

  std::int64_t last_collision_ = 0;  ///< of the piece
  double last_time_ = 0, last_second_ = 0;
  bool is_stopped_ = false;  ///< the piece has ended by the clock
  double stopped_at_ = 0;    ///< the latest end of a piece that came before the next event
};

/// A run at its start; as run_case, which it throws as.
std::unique_ptr<SteppedRun> start_run(const Case& values, const RunOptions& options);

/// A run at its last checkpoint; as resume_case, which it throws as.
std::unique_ptr<SteppedRun> resumed_run(const Case& values, RecoveredOutput output,
                                        const RunOptions& options);

}  // namespace zenosphere
