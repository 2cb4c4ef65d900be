#pragma once

#include <limits>
#include <optional>

#include "case/case.hpp"
#include "engine/simulation.hpp"
#include "run/log_rows.hpp"
#include "storage/output_file.hpp"

namespace zenosphere {

/// Writes what a run does into its output file, as the case asks: collisions and snapshots.
///
/// A row of the collision log holds the gap of the pair that collides *next*; so each row waits
/// for the collision after it.
template <int Dim, class Real>
class Recorder {
 public:
  /// \param file  outlives the recorder
  Recorder(const Case& values, const Simulation<Dim, Real>& simulation, OutputFile& file);

  /// The recorder that an archive holds, which took the snapshot of the start already.
  Recorder(const Case& values, const Simulation<Dim, Real>& simulation, OutputFile& file,
           ArchiveReader& archive);
  void archive_to(ArchiveWriter& archive) const { archive_members(*this, archive); }

  void observe(const Collision<Dim, Real>& collision) {
    if (output_.collision_log == CollisionLog::none) return;
    observe_next(collision.gap_before);
    if (waiting_) append(*waiting_);
    log_.write(collision, waiting_.emplace());
  }

  /// The gap, at the collision observed last, of the pair that collides next.
  void observe_next(const Real& gap) {
    if (waiting_) log_.complete(*waiting_, gap);
  }

  /// Time at which the next snapshot is due; infinity if none is.
  double next_snapshot() const { return next_snapshot_; }

  /// Takes the snapshot of the moment, and sets the next one an interval later.
  void take_snapshot(const Simulation<Dim, Real>& simulation);

  /// Writes the row that waits and the last state. The last call.
  void finish(const Simulation<Dim, Real>& simulation);

 private:
  template <class Self, class Archive>
  static void archive_members(Self& self, Archive& archive) {
    archive(self.waiting_, self.snapshots_, self.last_snapshot_time_, self.last_snapshot_step_);
    require_counts(self.snapshots_);
  }

  void append(const CollisionRow& row) {
    const bool is_windowed = output_.collision_log == CollisionLog::window;
    if (is_windowed && row.k < output_.log_first) return;
    if (is_windowed && output_.log_last && row.k > *output_.log_last) return;
    file_.append(row);
  }
  void schedule_snapshot();
  void schedule_next();
  double time_of(std::int64_t n) const;

  const Case::Output output_;
  bool clock_is_limited_;  ///< by run.time
  LogRows<Dim, Real> log_;
  OutputFile& file_;
  std::optional<CollisionRow> waiting_;
  std::int64_t snapshots_ = 0;  ///< intervals from the start to the next regular one
  double next_snapshot_ = std::numeric_limits<double>::infinity();
  double last_snapshot_time_ = -1;
  std::int64_t last_snapshot_step_ = -1;
};

}  // namespace zenosphere
