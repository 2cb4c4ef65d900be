#include "storage/output_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "model/errors.hpp"
#include "storage/hdf5.hpp"
#include "storage/integrity.hpp"

namespace zenosphere {
namespace {

namespace fs = std::filesystem;

/// A journal up to this size is not worth a new HDF5 file [bytes].
constexpr std::uint64_t least_fold = 64 << 20;

void remove_quietly(const fs::path& path) {
  std::error_code ignored;
  fs::resize_file(path, 0, ignored);  // HDF5 may still hold it: at least its space is free
  fs::remove(path, ignored);
}

/// Throws where a journal tells of an output that is not where it was.
void require_no_orphan(const Journal& journal, const fs::path& path, Existing existing) {
  if (existing == Existing::replace || journal.size() == 0) return;
  throw OutputError(fmt::format(
      "{}: belongs to a run whose {} is not here (moved or deleted?); put them together again, or "
      "delete it",
      journal.path().string(), path.filename().string()));
}

Journal opened_journal(const fs::path& path, const fs::path& target) {
  try {
    return Journal(target);
  } catch (const SystemError& error) {
    throw OutputError(fmt::format("{}: could not be created ({}); choose another place",
                                  path.string(), error.what()));
  }
}

}  // namespace

OutputFile::OutputFile(const fs::path& path, const Header& header, Existing existing)
    : path_(path),
      target_(permitted_target(path, existing)),
      part_path_(part_of(target_)),
      existing_(existing),
      journal_(opened_journal(path, target_)) {
  require_no_orphan(journal_, path, existing);
  buffer_.reserve(log_buffer);
  remove_quietly(part_path_);  // of a run that was killed
  guarded([&] { part_ = std::make_unique<OutputDatasets>(part_path_, header); });
}

OutputFile::OutputFile(RecoveredOutput recovered)
    : path_(recovered.path),
      target_(recovered.target),
      part_path_(part_of(target_)),
      existing_(Existing::replace),
      journal_(std::move(recovered.journal)),
      published_(identity_of(target_)),
      resolved_case_(std::move(recovered.info.resolved_case)),
      basis_(recovered.basis),
      log_rows_(recovered.checkpoint.log_rows),
      snapshots_(recovered.checkpoint.snapshots) {
  keep_in_mind(std::move(recovered.checkpoint));
  buffer_.reserve(log_buffer);
}

OutputFile::~OutputFile() {
  if (!part_) return;
  part_->abandon();
  remove_quietly(part_path_);
}

/// What the user still has, and what to do.
std::string OutputFile::what_is_kept() const {
  if (!published_) return "choose another place";
  return fmt::format(
      "everything up to collision {} (time {:.6g}) is kept: mend that, then zenosphere resume {}",
      last_.collisions, last_.time, path_.string());
}

template <class Action>
void OutputFile::guarded(Action action) {
  const auto fail = [this](const std::string& reason) {
    if (part_) part_->abandon();
    part_.reset();
    remove_quietly(part_path_);
    if (published_) require_in_place();  // or else that is the reason
    throw OutputError(fmt::format("{}: could not be {} ({}); {}", path_.string(),
                                  published_ ? "written" : "created", reason, what_is_kept()));
  };
  try {
    action();
  } catch (const hdf5::Error& error) {
    fail(error.what());
  } catch (const SystemError& error) {
    fail(error.what());
  } catch (const ArchiveError& error) {
    fail(error.what());
  }
}

void OutputFile::require_in_place() const {
  const bool is_whole =
      journal_.is_in_place() && (!published_ || identity_of(target_) == published_);
  if (is_whole) return;
  throw OutputError(fmt::format(
      "{}: it or its journal is no longer there (moved, deleted, or its folder is gone), so that "
      "nothing more can be kept; put both back, then zenosphere resume {}, or run the case again",
      path_.string(), path_.string()));
}

void OutputFile::write(const Snapshot& snapshot) {
  guarded([&] {
    if (part_) {
      part_->append(snapshot);
    } else {
      journal_.append(snapshot);
    }
    ++snapshots_;
  });
}

void OutputFile::flush_buffer() {
  guarded([&] { flush_rows(); });
}

void OutputFile::flush_rows() {
  if (buffer_.size() == 0) return;
  if (part_) {
    part_->append(buffer_);
  } else {
    journal_.append(buffer_);
  }
  buffer_.clear();
}

Checkpoint OutputFile::counted(Checkpoint checkpoint) const {
  checkpoint.log_rows = log_rows_;
  checkpoint.snapshots = snapshots_;
  return checkpoint;
}

void OutputFile::close_part() {
  part_->close();
  part_.reset();
}

/// Gives the next HDF5 file, once it is closed, its name.
void OutputFile::publish() {
  if (part_) close_part();
  put_in_place(part_path_, target_);
  published_ = identity_of(target_);
}

void OutputFile::begin(Checkpoint checkpoint) {
  assert(part_ && !published_);
  checkpoint = counted(std::move(checkpoint));
  permitted_target(path_, existing_);  // another process may have been faster
  guarded([&] {
    flush_rows();
    part_->store(checkpoint);
    publish();
    journal_.clear();
    clone_file(target_, part_path_);
    part_ = std::make_unique<OutputDatasets>(part_path_);
  });
}

void OutputFile::go_on(const std::string& resolved_case) {
  guarded([&] {
    if (journal_.size() == 0) journal_.begin(basis_);
    if (resolved_case != resolved_case_) journal_.append(resolved_case);
  });
}

void OutputFile::checkpoint(Checkpoint checkpoint) {
  require_in_place();
  checkpoint = counted(std::move(checkpoint));
  guarded([&] {
    flush_rows();
    if (!part_) return journal_.append(checkpoint);
    part_->store(checkpoint);
    publish();
    journal_.begin(basis_ = Basis::of(checkpoint));
  });
  keep_in_mind(std::move(checkpoint));
}

/// Remembers how far the run is safe.
void OutputFile::keep_in_mind(Checkpoint checkpoint) {
  last_ = std::move(checkpoint);
  last_.state = Bytes();  // that may be large
}

void OutputFile::fold_if_due() {
  if (part_ || journal_.size() < least_fold) return;
  guarded([&] {
    if (journal_.size() < size_of(target_)) return;
    const Checkpoint checkpoint = fold();
    part_->store(checkpoint);
    publish();
    journal_.begin(basis_ = Basis::of(checkpoint));
  });
}

void OutputFile::end(Checkpoint checkpoint) {
  require_in_place();
  checkpoint = counted(std::move(checkpoint));
  if (part_) {
    ending_ = std::move(checkpoint);
    return;
  }
  guarded([&] {
    flush_rows();
    journal_.append(checkpoint);
  });
  keep_in_mind(std::move(checkpoint));
}

void OutputFile::finish(const Summary& summary, const Anatomy& anatomy,
                        const RecordedSeries& series, const RecordedSamples& samples) {
  guarded([&] {
    flush_rows();
    if (!part_) ending_ = fold();
    part_->store(ending_);
    part_->finish(summary, anatomy, series, samples);
    close_part();
    seal(part_path_);
    publish();
  });
  journal_.remove();
}

/// Makes the next HDF5 file of the one before and everything in the journal, and returns the last
/// checkpoint in it.
Checkpoint OutputFile::fold() {
  clone_file(target_, part_path_);
  part_ = std::make_unique<OutputDatasets>(part_path_);
  part_->rewind_to(basis_.log_rows, basis_.snapshots);
  std::optional<JournalRecord> last;
  std::int64_t log_rows = 0, snapshots = 0;
  JournalReader reader(journal_.file());
  while (const auto record = reader.next()) {
    if (record->kind != RecordKind::checkpoint) {
      replay(reader.payload(*record), record->kind);
      continue;
    }
    last = record;
    log_rows = part_->log_rows();
    snapshots = part_->snapshots();
  }
  require_archived(last.has_value(), "the journal has lost its checkpoint");
  const Bytes bytes = reader.payload(*last);
  auto checkpoint = ArchiveReader(bytes).next<Checkpoint>();
  require_archived(checkpoint.log_rows == log_rows && checkpoint.snapshots == snapshots,
                   "the journal lacks something that its checkpoint counts");
  return checkpoint;
}

/// Adds a record of the journal to the next HDF5 file.
void OutputFile::replay(const Bytes& payload, RecordKind kind) {
  ArchiveReader archive(payload);
  if (kind == RecordKind::rows) part_->append(archive.next<CollisionRows>());
  if (kind == RecordKind::snapshot) part_->append(archive.next<Snapshot>());
  if (kind == RecordKind::resolved_case) part_->set_resolved_case(archive.next<std::string>());
}

}  // namespace zenosphere
