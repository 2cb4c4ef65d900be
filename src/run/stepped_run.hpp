#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "case/case.hpp"
#include "result/summary.hpp"
#include "run/run.hpp"
#include "storage/records.hpp"
#include "storage/recovery.hpp"

namespace zenosphere {

/// Where a piece of a run ends; what comes first counts. A limit of the case ends it too.
struct Piece {
  std::int64_t collisions = std::numeric_limits<std::int64_t>::max();  ///< at most so many more
  double time = std::numeric_limits<double>::infinity();               ///< since the start
  double seconds = std::numeric_limits<double>::infinity();            ///< of wall time, roughly
};

/// The spheres at one time, with their velocities relative to the imposed profile.
struct SphereState {
  Snapshot snapshot;
  std::vector<double> peculiar_velocities;  ///< N x D, row-major, diameters/time
};

/// A run that is driven from outside piece by piece, whatever its dimension and precision.
///
/// A run in pieces gives the same bits as one that goes through, in its summary and its output:
/// between two pieces the clock stands at an event, and what is asked for in between is told by a
/// copy. Not to be used by two threads at once.
class SteppedRun {
 public:
  virtual ~SteppedRun() = default;

  /// Goes on to the end of the piece or of the run.
  ///
  /// \param rows  the collisions of the piece are appended to it; null: they are not wanted. The
  ///              last one waits for the gap of the next pair and comes first in the next piece;
  ///              at the end of the run it comes at once
  /// Throws OutputError where the file cannot be written; then the run can only be destroyed.
  virtual void advance(const Piece& piece, std::vector<CollisionRow>* rows) = 0;

  /// Whether a limit of the case, or what else ends a run, has been reached.
  virtual bool is_over() const = 0;

  virtual std::int64_t collisions() const = 0;
  virtual double time() const = 0;  ///< the end of the last piece, where nothing happened before it

  /// What the run came to so far; its outcome is "unfinished" until it is over.
  virtual Summary summary() const = 0;
  virtual SphereState state() const = 0;

  /// Makes sure that the run can be resumed from here, where it has an output.
  virtual void save() = 0;

  /// Ends the run, here if it is not over: writes what is left to write. The last call that may
  /// change anything.
  virtual Summary finish() = 0;
};

/// A run at its start; as run_case, which it throws as.
std::unique_ptr<SteppedRun> start_run(const Case& values, const RunOptions& options);

/// A run at its last checkpoint; as resume_case, which it throws as.
std::unique_ptr<SteppedRun> resumed_run(const Case& values, RecoveredOutput output,
                                        const RunOptions& options);

}  // namespace zenosphere
