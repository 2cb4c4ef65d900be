#include "storage/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <array>
#include <bit>
#include <cerrno>
#include <cstring>

#include "model/errors.hpp"
#include "storage/checksum.hpp"

namespace zenosphere {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t magic = 0x4c4e524a4f4e455a;  // "ZENOJRNL"
constexpr std::uint32_t version = 3 + log_version;
constexpr std::size_t header_size = 8 + 4 + (4 * 8 + 4) + 4;
constexpr std::size_t record_header_size = 4 + 4 + 8;

/// Numbers as an archive has them.
template <class Number>
std::span<const std::uint8_t> bytes_of(std::span<const Number> numbers) {
  static_assert(std::endian::native == std::endian::little);
  return {reinterpret_cast<const std::uint8_t*>(numbers.data()), numbers.size_bytes()};
}

Bytes header(const Basis& basis) {
  ArchiveWriter archive;
  archive(magic, version, basis);
  archive(checksum(archive.bytes()));
  return archive.release();
}

using Piece = std::span<const std::uint8_t>;

/// The checksum of a record covers what is around it too: a payload under another kind is none.
std::uint32_t record_checksum(std::uint32_t seed, RecordKind kind, std::span<const Piece> payload) {
  std::uint64_t size = 0;
  for (const Piece piece : payload) size += piece.size();
  ArchiveWriter archive;
  archive(static_cast<std::uint32_t>(kind), size);
  std::uint32_t sum = checksum(archive.bytes(), seed);
  for (const Piece piece : payload) sum = checksum(piece, sum);
  return sum;
}

template <class Payload>
Payload decoded(const Bytes& bytes) {
  ArchiveReader archive(bytes);
  Payload payload;
  archive(payload);
  archive.require_end();
  return payload;
}

std::uint32_t checksum_in(const Bytes& header) {
  std::uint32_t value = 0;
  std::memcpy(&value, header.data() + header.size() - sizeof value, sizeof value);
  return value;
}

FileDescriptor locked(const fs::path& path) {
  for (;;) {
    FileDescriptor file(path, O_RDWR | O_CREAT);
    if (flock(file.id(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      throw OutputError(path.string() +
                        ": is locked (another run writes this output); wait until it has ended, "
                        "or choose another output");
    }
    // Whoever held the lock before may have deleted the file since it was opened here.
    if (identity_of(path) == identity_of(file)) return file;
  }
}

}  // namespace

fs::path journal_of(const fs::path& output) {
  fs::path name = output;
  name += ".journal";
  return name;
}

JournalReader::JournalReader(const FileDescriptor& file) : file_(file), size_(size_of(file)) {
  const Bytes bytes = read_at(file, 0, header_size);
  if (bytes.size() < header_size) return;
  ArchiveReader archive(bytes);
  const auto found_magic = archive.next<std::uint64_t>();
  const auto found_version = archive.next<std::uint32_t>();
  const auto basis = archive.next<Basis>();
  const auto expected = archive.next<std::uint32_t>();
  const std::span<const std::uint8_t> covered(bytes.data(), header_size - sizeof expected);
  const bool is_journal = found_magic == magic && checksum(covered) == expected;
  require_archived(is_journal, "no journal of a run, or its header is damaged");
  require_archived(found_version == version, "a journal of another version of this program");
  basis_ = basis;
  place_ = header_size;
  seed_ = expected;
}

std::optional<JournalRecord> JournalReader::next() {
  if (!basis_ || size_ - place_ < record_header_size) return std::nullopt;
  const Bytes bytes = read_at(file_, place_, record_header_size);
  if (bytes.size() < record_header_size) return std::nullopt;
  ArchiveReader archive(bytes);
  JournalRecord record{};
  record.kind = RecordKind{archive.next<std::uint32_t>()};
  record.checksum = archive.next<std::uint32_t>();
  record.length = archive.next<std::uint64_t>();
  record.offset = place_ + record_header_size;
  const bool is_known =
      record.kind >= RecordKind::resolved_case && record.kind <= RecordKind::checkpoint;
  if (!is_known || record.length > size_ - record.offset) return std::nullopt;
  place_ = record.end();
  return record;
}

Bytes JournalReader::payload(const JournalRecord& record) const {
  Bytes bytes = read_at(file_, record.offset, static_cast<std::size_t>(record.length));
  const bool is_whole =
      bytes.size() == record.length &&
      record_checksum(seed_, record.kind, std::array{Piece(bytes)}) == record.checksum;
  require_archived(is_whole, "a record that was not written whole");
  return bytes;
}

namespace {

/// Whether the bytes of a record are those that were written.
bool is_whole(const JournalReader& reader, const JournalRecord& record) {
  try {
    reader.payload(record);
    return true;
  } catch (const ArchiveError&) {
    return false;
  }
}

}  // namespace

JournalContents contents_of(const FileDescriptor& journal, Thoroughness thoroughness) {
  JournalReader reader(journal);
  JournalContents contents;
  contents.end = reader.basis() ? header_size : 0;
  std::optional<JournalRecord> checkpoint, resolved_case;
  while (const auto record = reader.next()) {
    const bool is_bulk = record->kind == RecordKind::rows || record->kind == RecordKind::snapshot;
    const bool is_looked_at = !is_bulk || thoroughness == Thoroughness::every_byte;
    if (is_looked_at && !is_whole(reader, *record)) break;
    if (is_bulk) continue;
    // A new end of the run counts without a checkpoint, if nothing before it is to be dropped.
    const bool counts = record->kind == RecordKind::checkpoint ||
                        contents.end == record->offset - record_header_size;
    if (!counts) continue;
    contents.end = record->end();
    (record->kind == RecordKind::checkpoint ? checkpoint : resolved_case) = record;
  }
  if (checkpoint) contents.checkpoint = decoded<Checkpoint>(reader.payload(*checkpoint));
  if (resolved_case) contents.resolved_case = decoded<std::string>(reader.payload(*resolved_case));
  return contents;
}

Journal::Journal(const fs::path& output)
    : path_(journal_of(output)), file_(locked(path_)), size_(size_of(file_)) {}

Journal::~Journal() {
  if (file_.id() >= 0 && size_ == 0) remove();
}

void Journal::begin(const Basis& basis) {
  clear();
  const Bytes bytes = header(basis);
  write_at(file_, 0, bytes);
  size_ = bytes.size();
  seed_ = checksum_in(bytes);
  sync(file_);
  sync_folder_of(path_);
}

void Journal::continue_after(const Basis& basis, const JournalContents& contents) {
  cut(file_, contents.end);
  size_ = contents.end;
  seed_ = checksum_in(header(basis));
}

void Journal::clear() {
  cut(file_, 0);
  size_ = 0;
}

template <class Payload>
void Journal::append(RecordKind kind, const Payload& payload) {
  ArchiveWriter archive;
  archive(payload);
  write(kind, std::array{Piece(archive.bytes())});
}

void Journal::write(RecordKind kind, std::span<const Piece> payload) {
  std::uint64_t size = 0;
  for (const Piece piece : payload) size += piece.size();
  ArchiveWriter head;
  head(static_cast<std::uint32_t>(kind), record_checksum(seed_, kind, payload), size);
  std::vector<Piece> pieces{head.bytes()};
  pieces.insert(pieces.end(), payload.begin(), payload.end());
  try {
    write_at(file_, size_, pieces);
  } catch (const SystemError&) {
    cut(file_, size_);  // gives the space back, too
    throw;
  }
  size_ += record_header_size + size;
}

/// Rows are many: their columns go to the file from where they are.
void Journal::append(const CollisionRows& rows) {
  const std::uint64_t length = rows.size();
  std::vector<Piece> pieces;
  CollisionRows::fields(rows, [&](const char*, const auto& column, auto) {
    pieces.push_back(bytes_of(std::span(&length, 1)));
    pieces.push_back(bytes_of(std::span(column)));
  });
  write(RecordKind::rows, pieces);
}

void Journal::append(const Snapshot& snapshot) { append(RecordKind::snapshot, snapshot); }

void Journal::append(const Checkpoint& checkpoint) {
  append(RecordKind::checkpoint, checkpoint);
  sync(file_);
}

void Journal::append(const std::string& resolved_case) {
  append(RecordKind::resolved_case, resolved_case);
  sync(file_);
}

bool Journal::is_in_place() const { return identity_of(path_) == identity_of(file_); }

void Journal::remove() {
  std::error_code ignored;  // it is void, and says so itself
  if (is_in_place()) fs::remove(path_, ignored);
  file_ = FileDescriptor();
}

}  // namespace zenosphere
