#include "storage/journal_tail.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <string>
#include <utility>

#include "model/errors.hpp"

namespace zenosphere {
namespace {

namespace fs = std::filesystem;

fs::path journal_beside(const fs::path& path) {
  std::error_code ignored;
  return journal_of(fs::is_symlink(path, ignored) ? fs::canonical(path, ignored) : path);
}

/// Reads the journal of a run that may go on at the same time.
template <class Action>
auto reading_live(const fs::path& journal, Action action) {
  try {
    return action();
  } catch (const std::runtime_error& error) {  // of the system, or nonsense in the file
    throw InputError(fmt::format(
        "{}: cannot be read ({}); if its run goes on, try again, else it may be damaged",
        journal.string(), error.what()));
  }
}

}  // namespace

JournalTail::Opened::Opened(const fs::path& path) : file(path, O_RDONLY), reader(file) {}

JournalTail::JournalTail(const fs::path& path, const OutputInfo& stored)
    : path_(journal_beside(path)),
      dimension_(stored.dimension),
      spheres_(stored.spheres),
      basis_(stored.basis) {
  std::error_code ignored;
  if (!stored.checkpoint || !fs::exists(path_, ignored)) return;
  reading_live(path_, [&] {
    opened_ = std::make_unique<Opened>(path_);
    fits_ = opened_->reader.basis() == basis_;
    if (!fits_) return;
    contents_ = contents_of(opened_->file, Thoroughness::checkpoints);
    if (goes_on()) list_records(stored);
  });
}

/// Notes where the snapshots and the rows are.
void JournalTail::list_records(const OutputInfo& stored) {
  const bool is_there = basis_.snapshots <= stored.snapshots &&
                        basis_.log_rows <= stored.logged_collisions && basis_.snapshots >= 0 &&
                        basis_.log_rows >= 0;
  require_archived(is_there, "it goes on from more than there is");
  while (const auto record = opened_->reader.next()) {
    if (record->end() > contents_.end) break;
    if (record->kind == RecordKind::snapshot) snapshots_.push_back(*record);
    if (record->kind == RecordKind::rows) rows_.push_back(*record);
  }
  const bool is_whole = basis_.snapshots + snapshots() == checkpoint().snapshots;
  require_archived(is_whole, "it lacks snapshots");
}

template <class Part>
Part JournalTail::decoded(const std::vector<JournalRecord>& records, std::int64_t n) const {
  const Bytes bytes = opened_->reader.payload(records.at(static_cast<std::size_t>(n)));
  ArchiveReader archive(bytes);
  Part part;
  archive(part);
  archive.require_end();
  return part;
}

Snapshot JournalTail::snapshot(std::int64_t n) const {
  return reading_live(path_, [&] {
    auto snapshot = decoded<Snapshot>(snapshots_, n);
    const auto dimension = static_cast<std::size_t>(dimension_);
    const std::size_t components = static_cast<std::size_t>(spheres_) * dimension;
    const std::size_t spins = snapshot.angular_velocities.size();
    const std::size_t axes = dimension == 3 ? 3 : 1;
    const bool fits =
        (spins == 0 || spins == static_cast<std::size_t>(spheres_) * axes) &&
        snapshot.positions.size() == components && snapshot.velocities.size() == components &&
        snapshot.images.size() == components && snapshot.box_edges.size() == dimension * dimension;
    require_archived(fits, "a snapshot of another number of spheres");
    return snapshot;
  });
}

std::vector<CollisionRow> JournalTail::log_piece(std::int64_t n) const {
  return reading_live(path_, [&] {
    const auto columns = decoded<CollisionRows>(rows_, n);
    std::vector<CollisionRow> piece;
    piece.reserve(columns.size());
    for (std::size_t row = 0; row < columns.size(); ++row) piece.push_back(columns.row(row));
    return piece;
  });
}

void JournalTail::add_to(OutputInfo& info) const {
  if (contents_.resolved_case) info.resolved_case = *contents_.resolved_case;
  if (goes_on()) {
    info.checkpoint = contents_.checkpoint;
    info.is_extended = info.complete;
  }
  if (info.complete || !info.checkpoint) return;
  info.snapshots = info.checkpoint->snapshots;
  info.logged_collisions = info.checkpoint->log_rows;
  info.last_collision = info.checkpoint->collisions;
  info.last_time = info.checkpoint->time;
}

}  // namespace zenosphere
