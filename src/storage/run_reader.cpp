#include "storage/run_reader.hpp"

#include <utility>

namespace zenosphere {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t rows_at_once = 65536;

/// That of the file, with lengths and end of all that can be read, of a longer run too.
OutputInfo info_of_run(const OutputInfo& stored, const JournalTail& tail) {
  OutputInfo info = stored;
  tail.add_to(info);
  info.snapshots = stored.snapshots;
  info.logged_collisions = stored.logged_collisions;
  if (!tail.goes_on()) return info;
  info.snapshots = tail.basis().snapshots + tail.snapshots();
  info.logged_collisions = tail.checkpoint().log_rows;
  info.last_collision = tail.checkpoint().collisions;
  info.last_time = tail.checkpoint().time;
  return info;
}

}  // namespace

std::int64_t bytes_of_run(const fs::path& path) {
  std::int64_t bytes = 0;
  for (const fs::path& file : {path, journal_of(path)}) {
    std::error_code failure;
    const auto size = fs::file_size(file, failure);
    if (!failure) bytes += static_cast<std::int64_t>(size);
  }
  return bytes;
}

RunReader::RunReader(const fs::path& path)
    : RunReader(with_journal<StoredRun>(path, [&] { return StoredRun(path); })) {}

RunReader::RunReader(WithJournal<StoredRun> run)
    : file_(std::move(run.stored)),
      tail_(std::move(run.tail)),
      info_(info_of_run(file_.info(), tail_)),
      stored_snapshots_(tail_.goes_on() ? tail_.basis().snapshots : file_.info().snapshots),
      stored_rows_(tail_.goes_on() ? tail_.basis().log_rows : file_.info().logged_collisions) {}

Snapshot RunReader::snapshot(std::int64_t n) const {
  return n < stored_snapshots_ ? file_.snapshot(n) : tail_.snapshot(n - stored_snapshots_);
}

RecordedSeries RunReader::series() const {
  return tail_.goes_on() ? tail_.checkpoint().series : file_.series();
}

RecordedSamples RunReader::samples() const {
  return tail_.goes_on() ? tail_.checkpoint().samples : file_.samples();
}

std::int64_t RunReader::stored_pieces() const {
  return (stored_rows_ + rows_at_once - 1) / rows_at_once;
}

std::vector<CollisionRow> RunReader::log_piece(std::int64_t n) const {
  if (n >= stored_pieces()) return tail_.log_piece(n - stored_pieces());
  const std::int64_t first = n * rows_at_once;
  return file_.rows(first, std::min(rows_at_once, stored_rows_ - first));
}

}  // namespace zenosphere
