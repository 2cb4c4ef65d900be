#include "storage/recorded_run.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "model/errors.hpp"

namespace zenosphere {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t rows_at_once = 65536;

fs::path journal_beside(const fs::path& path) {
  std::error_code ignored;
  return journal_of(fs::is_symlink(path, ignored) ? fs::canonical(path, ignored) : path);
}

/// Reads the journal of an output file, whose run may go on at the same time.
template <class Action>
auto reading_live(const fs::path& path, Action action) {
  try {
    return action();
  } catch (const std::runtime_error& error) {  // of the system, or nonsense in the file
    throw InputError(fmt::format(
        "{}: cannot be read ({}); if its run goes on, try again, else it may be damaged",
        journal_beside(path).string(), error.what()));
  }
}

}  // namespace

RecordedRun::RecordedRun(const fs::path& path)
    : path_(path),
      file_(path),
      stored_snapshots_(file_.info().snapshots),
      stored_rows_(file_.info().logged_collisions) {
  std::error_code ignored;
  if (!file_.info().checkpoint || !fs::exists(journal_beside(path), ignored)) return;
  reading_live(path, [&] { add_journal(); });
}

/// Looks for what is newer than the output file, of which the part behind the checkpoint is then
/// void.
void RecordedRun::add_journal() {
  journal_file_ = FileDescriptor(journal_beside(path_), O_RDONLY);
  const Basis& basis = file_.info().basis;
  if (JournalReader(journal_file_).basis() != basis) return;
  JournalContents contents = contents_of(journal_file_, Thoroughness::checkpoints);
  if (!contents.checkpoint) return;
  newer_series_ = std::move(contents.checkpoint->series);
  newer_samples_ = std::move(contents.checkpoint->samples);
  const bool is_there = basis.snapshots <= stored_snapshots_ && basis.log_rows <= stored_rows_ &&
                        basis.snapshots >= 0 && basis.log_rows >= 0;
  require_archived(is_there, "it goes on from more than there is");
  stored_snapshots_ = basis.snapshots;
  stored_rows_ = basis.log_rows;
  list_records(contents.end);
  require_archived(snapshots() == contents.checkpoint->snapshots, "it lacks snapshots");
}

/// Notes where the snapshots and the rows are.
void RecordedRun::list_records(std::uint64_t end) {
  journal_.emplace(journal_file_);
  while (const auto record = journal_->next()) {
    if (record->end() > end) break;
    if (record->kind == RecordKind::snapshot) snapshots_.push_back(*record);
    if (record->kind == RecordKind::rows) rows_.push_back(*record);
  }
}

template <class Part>
Part RecordedRun::decoded(const JournalRecord& record) const {
  const Bytes bytes = journal_->payload(record);
  ArchiveReader archive(bytes);
  Part part;
  archive(part);
  archive.require_end();
  return part;
}

Snapshot RecordedRun::snapshot(std::int64_t n) const {
  if (n < stored_snapshots_) return file_.snapshot(n);
  return reading_live(path_, [&] {
    auto snapshot =
        decoded<Snapshot>(snapshots_.at(static_cast<std::size_t>(n - stored_snapshots_)));
    const auto dimension = static_cast<std::size_t>(info().dimension);
    const std::size_t components = static_cast<std::size_t>(info().spheres) * dimension;
    const std::size_t spins = snapshot.angular_velocities.size();
    const std::size_t axes = dimension == 3 ? 3 : 1;
    const bool fits =
        (spins == 0 || spins == static_cast<std::size_t>(info().spheres) * axes) &&
        snapshot.positions.size() == components && snapshot.velocities.size() == components &&
        snapshot.images.size() == components && snapshot.box_edges.size() == dimension * dimension;
    require_archived(fits, "a snapshot of another number of spheres");
    return snapshot;
  });
}

std::int64_t RecordedRun::stored_pieces() const {
  return (stored_rows_ + rows_at_once - 1) / rows_at_once;
}

std::int64_t RecordedRun::log_pieces() const { return stored_pieces() + size_of_part(rows_); }

std::vector<CollisionRow> RecordedRun::log_piece(std::int64_t n) const {
  if (n < stored_pieces()) {
    const std::int64_t first = n * rows_at_once;
    return file_.rows(first, std::min(rows_at_once, stored_rows_ - first));
  }
  return reading_live(path_, [&] {
    const auto rows =
        decoded<CollisionRows>(rows_.at(static_cast<std::size_t>(n - stored_pieces())));
    std::vector<CollisionRow> piece;
    piece.reserve(rows.size());
    for (std::size_t row = 0; row < rows.size(); ++row) {
      piece.push_back({rows.k[row], rows.time[row], rows.i[row], rows.j[row], rows.gap[row],
                       rows.normal_speed[row], rows.flags[row]});
    }
    return piece;
  });
}

}  // namespace zenosphere
