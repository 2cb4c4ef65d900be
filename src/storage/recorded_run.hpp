#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "storage/durable.hpp"
#include "storage/journal.hpp"
#include "storage/records.hpp"
#include "storage/run_file.hpp"

namespace zenosphere {

/// All that a run has recorded so far: its output file and, where that goes on from it, the journal
/// beside it up to its last checkpoint. Nothing is written or locked.
class RecordedRun {
 public:
  /// Throws InputError as read_output_info does, and where the journal lacks something.
  explicit RecordedRun(const std::filesystem::path& path);
  RecordedRun(const RecordedRun&) = delete;
  RecordedRun& operator=(const RecordedRun&) = delete;

  /// What the output file says about itself; its lengths are those of the file without the journal.
  const OutputInfo& info() const { return file_.info(); }

  std::int64_t snapshots() const { return stored_snapshots_ + size_of_part(snapshots_); }
  /// Snapshot `n`, from 0. Throws InputError where it cannot be read.
  Snapshot snapshot(std::int64_t n) const;

  /// The time series up to the end of the run, or to its last checkpoint. Throws InputError where
  /// it cannot be read.
  RecordedSeries series() const { return newer_series_ ? *newer_series_ : file_.series(); }
  /// What has been accumulated of the structure; likewise.
  RecordedSamples samples() const { return newer_samples_ ? *newer_samples_ : file_.samples(); }

  /// The collision log comes in pieces of at most 65536 rows; how many there are.
  std::int64_t log_pieces() const;
  /// Piece `n` of the log, from 0. Throws InputError where it cannot be read.
  std::vector<CollisionRow> log_piece(std::int64_t n) const;

 private:
  static std::int64_t size_of_part(const std::vector<JournalRecord>& records) {
    return static_cast<std::int64_t>(records.size());
  }
  std::int64_t stored_pieces() const;
  void add_journal();
  void list_records(std::uint64_t end);
  template <class Part>
  Part decoded(const JournalRecord& record) const;

  std::filesystem::path path_;
  RunFile file_;
  std::int64_t stored_snapshots_ = 0;             ///< that count, of those in the output file
  std::int64_t stored_rows_ = 0;                  ///< likewise
  std::optional<RecordedSeries> newer_series_;    ///< of the journal
  std::optional<RecordedSamples> newer_samples_;  ///< likewise
  FileDescriptor journal_file_;
  std::optional<JournalReader> journal_;
  std::vector<JournalRecord> snapshots_;  ///< of the journal
  std::vector<JournalRecord> rows_;       ///< likewise
};

}  // namespace zenosphere
