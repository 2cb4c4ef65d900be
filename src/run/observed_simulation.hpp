#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "case/case.hpp"
#include "flow/observable_series.hpp"
#include "result/summary.hpp"
#include "storage/output_file.hpp"
#include "storage/records.hpp"
#include "storage/recovery.hpp"

namespace zenosphere {

/// The spheres at one time, with their velocities relative to the imposed profile.
struct SphereState {
  Snapshot snapshot;
  std::vector<double> peculiar_velocities;  ///< N x D, row-major, diameters/time
};

/// How far a simulation goes on at most before its run looks after other things.
struct Stretch {
  std::int64_t collisions = 0;  ///< since the start
  double time = 0;              ///< since the start; where nothing happens before, the clock stays
  int rounds = 0;               ///< collisions, and whiles without one
};

/// Where a stretch has ended.
struct Halt {
  int rounds = 0;
  bool is_waiting = false;  ///< nothing happens up to its time
};

/// The simulation of a run with what drives, observes and records it, whatever its dimension and
/// precision. In Digits all calls but those of counts need the precision of the case
/// (CasePrecision).
///
/// A call costs nothing beside what it does: none of them is made for each collision.
class ObservedSimulation {
 public:
  virtual ~ObservedSimulation() = default;

  /// Records into a file, which outlives this, from here on; or, where the state of a checkpoint is
  /// read, on from there.
  ///
  /// Throws ArchiveError where that state cannot be.
  virtual void record_to(OutputFile& file) = 0;
  virtual void record_to(OutputFile& file, ArchiveReader& state) = 0;

  /// Begins a piece of the run; its rows are appended to `rows`, null: they are not wanted.
  virtual void begin_piece(std::vector<CollisionRow>* rows) = 0;
  /// Ends it; the last row of a piece that is not the last of the run waits for the next one.
  virtual void end_piece(bool is_last) = 0;

  /// Goes from collision to collision, each of them observed, up to the end of the stretch, or
  /// until what_ends() has an answer.
  virtual Halt go_on(const Stretch& stretch) = 0;

  /// Why the run ends here, if it does.
  virtual std::optional<EndedBy> what_ends() const = 0;

  /// Time of the next event that is no collision: a kick, a snapshot, the end of the run.
  virtual double next_pause() const = 0;
  virtual double last_moment() const = 0;   ///< see `last_moment` in ending.hpp
  virtual double end_of_clock() const = 0;  ///< time

  /// Lets the clock go on to such a time, up to which nothing happens, and does what is due.
  ///
  /// \param is_last  the run ends there: the last snapshot is of what its summary tells
  virtual void pause_at(double time, bool is_last) = 0;

  /// Ends the run: goes on to `time`, where that is later and nothing happens up to it, has a last
  /// look at everything, and records what waits.
  virtual void close(double time) = 0;

  virtual std::int64_t collisions() const = 0;
  virtual double time() const = 0;  ///< of the clock
  virtual std::int64_t separation_hits() const = 0;
  virtual const Anatomy& anatomy() const = 0;
  virtual ObservableSeries series() const = 0;
  virtual RecordedSamples samples() const = 0;  ///< empty without `measure.sampling_interval`

  /// Adds what has been observed, as it is at `time` where nothing happens up to there.
  virtual void add_to(Summary& summary, double time) const = 0;
  virtual SphereState state(double time) const = 0;

  /// Adds the clock and the state.
  virtual void add_to(Checkpoint& checkpoint) const = 0;
};

/// The simulation of a case at its start.
///
/// \param values, interrupt  outlive it; null: nothing interrupts it
/// Throws InputError where the start cannot be made.
std::unique_ptr<ObservedSimulation> new_observed(const Case& values,
                                                 const std::atomic<bool>* interrupt);

/// The simulation at the checkpoint of an output.
///
/// \param state  of that checkpoint; what the recorder has in it is left
/// Throws InputError for a version that this program does not read, ArchiveError for a state that
/// cannot be.
std::unique_ptr<ObservedSimulation> archived_observed(const Case& values,
                                                      const std::atomic<bool>* interrupt,
                                                      const RecoveredOutput& output,
                                                      ArchiveReader& state);

}  // namespace zenosphere
