#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "collapse/dissection.hpp"
#include "model/grains.hpp"
#include "storage/journal_tail.hpp"
#include "storage/output_info.hpp"
#include "storage/records.hpp"
#include "storage/stored_run.hpp"

namespace zenosphere {

/// What reading all of a run returns, with its journal, roughly [bytes]: for sandboxed_read.
std::int64_t bytes_of_run(const std::filesystem::path& path);

/// All that a run has recorded so far: its output file and, where that goes on from it, the journal
/// beside it up to its last checkpoint. Nothing is written or locked. Snapshots come one by one,
/// the log in pieces: a run may be larger than the memory.
///
/// Every function throws InputError where it cannot be read.
class RunReader {
 public:
  /// Throws InputError as read_output_info does, where columns have different lengths, and where
  /// the journal lacks something.
  explicit RunReader(const std::filesystem::path& path);

  /// What the output says about itself; lengths and end are those of all that can be read here.
  const OutputInfo& info() const { return info_; }

  std::int64_t snapshots() const { return info_.snapshots; }
  /// Snapshot `n`, from 0.
  Snapshot snapshot(std::int64_t n) const;

  /// What the spheres are; all empty where they are unit spheres of one kind.
  Grains<double> grains() const { return file_.grains(); }

  /// The collision log comes in pieces of at most 65536 rows; how many there are.
  std::int64_t log_pieces() const { return stored_pieces() + tail_.log_pieces(); }
  /// Piece `n` of the log, from 0.
  std::vector<CollisionRow> log_piece(std::int64_t n) const;
  /// Calls `action(row)` for every row of the log, a piece of it in memory at a time.
  template <class Action>
  void for_each_row(Action&& action) const {
    for (std::int64_t n = 0; n < log_pieces(); ++n) {
      for (const CollisionRow& row : log_piece(n)) action(row);
    }
  }

  /// The time series up to the end of the run, or to its last checkpoint.
  RecordedSeries series() const;
  /// What has been accumulated of the structure; likewise.
  RecordedSamples samples() const;

  /// What was found at the first hit and at the arrest; of a finished run.
  Anatomy anatomy() const { return file_.anatomy(); }

 private:
  explicit RunReader(WithJournal<StoredRun> run);
  std::int64_t stored_pieces() const;

  StoredRun file_;
  JournalTail tail_;
  OutputInfo info_;
  std::int64_t stored_snapshots_;  ///< those of the file that count
  std::int64_t stored_rows_;       ///< likewise
};

}  // namespace zenosphere
