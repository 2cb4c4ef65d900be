#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "storage/durable.hpp"
#include "storage/journal.hpp"
#include "storage/output_info.hpp"
#include "storage/records.hpp"

namespace zenosphere {

/// What the journal of an output adds to the file: everything up to its last whole checkpoint.
/// Nothing where there is no journal, or one that goes on from another file. Nothing is written or
/// locked: the run may go on at the same time.
///
/// Every function throws InputError where the journal cannot be read or lacks something.
class JournalTail {
 public:
  /// \param stored  what the output file says without its journal
  JournalTail(const std::filesystem::path& path, const OutputInfo& stored);

  /// False where there is a journal that does not go on from this file.
  bool fits() const { return fits_; }
  /// Whether the run has come further than the file.
  bool goes_on() const { return contents_.checkpoint.has_value(); }

  /// Rows and snapshots of the file that are not void: up to the checkpoint that the journal goes
  /// on from.
  const Basis& basis() const { return basis_; }
  /// The last checkpoint. Only where goes_on().
  const Checkpoint& checkpoint() const { return *contents_.checkpoint; }

  std::int64_t snapshots() const { return static_cast<std::int64_t>(snapshots_.size()); }
  /// Snapshot `n` of the journal, from 0, of so many spheres as the file has.
  Snapshot snapshot(std::int64_t n) const;

  std::int64_t log_pieces() const { return static_cast<std::int64_t>(rows_.size()); }
  /// Piece `n` of its part of the collision log, from 0.
  std::vector<CollisionRow> log_piece(std::int64_t n) const;

  /// Completes what a file says of its run by what the journal knows: its lengths and its end.
  /// Those of a finished run stay, that of a longer one is its checkpoint.
  void add_to(OutputInfo& info) const;

 private:
  struct Opened {
    explicit Opened(const std::filesystem::path& path);
    FileDescriptor file;
    JournalReader reader;
  };

  void list_records(const OutputInfo& stored);
  template <class Part>
  Part decoded(const std::vector<JournalRecord>& records, std::int64_t n) const;

  std::filesystem::path path_;  ///< of the journal
  int dimension_;
  std::int64_t spheres_;
  Basis basis_;
  bool fits_ = true;
  JournalContents contents_{};
  std::unique_ptr<Opened> opened_{};
  std::vector<JournalRecord> snapshots_{}, rows_{};
};

/// What is stored in a file and what its journal adds, from one moment: a running run may put a new
/// file in place between two looks.
template <class Stored>
struct WithJournal {
  Stored stored;
  JournalTail tail;
};

inline const OutputInfo& info_in(const OutputInfo& info) { return info; }
template <class Stored>
const OutputInfo& info_in(const Stored& stored) {
  return stored.info();
}

/// \param open  opens or reads the file
template <class Stored, class Open>
WithJournal<Stored> with_journal(const std::filesystem::path& path, Open open) {
  constexpr int tries = 3;
  for (int attempt = 1;; ++attempt) {
    const auto before = identity_of(path);
    Stored stored = open();
    JournalTail tail(path, info_in(stored));
    const bool is_replaced = !tail.fits() && identity_of(path) != before;
    if (is_replaced && attempt < tries) continue;
    return {std::move(stored), std::move(tail)};
  }
}

}  // namespace zenosphere
