#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "storage/durable.hpp"
#include "storage/records.hpp"

namespace zenosphere {

/// The name of the journal of an output file.
std::filesystem::path journal_of(const std::filesystem::path& output);

enum class RecordKind : std::uint32_t { resolved_case = 1, rows = 2, snapshot = 3, checkpoint = 4 };

/// Where a record of a journal is.
struct JournalRecord {
  RecordKind kind;
  std::uint32_t checksum;
  std::uint64_t offset;  ///< of its payload
  std::uint64_t length;  ///< of its payload [bytes]
  std::uint64_t end() const { return offset + length; }
};

/// Reads the records of a journal one after the other, up to the first that is not whole.
class JournalReader {
 public:
  /// \param file  outlives the reader
  explicit JournalReader(const FileDescriptor& file);

  /// What the journal goes on from; nothing where there is no whole header.
  const std::optional<Basis>& basis() const { return basis_; }

  /// The next record that lies in the file as a whole; its bytes are not looked at.
  std::optional<JournalRecord> next();

  /// The bytes of a record. Throws ArchiveError where they are not those that were written.
  Bytes payload(const JournalRecord& record) const;

 private:
  const FileDescriptor& file_;
  std::uint64_t size_;
  std::uint64_t place_ = 0;
  std::uint32_t seed_ = 0;
  std::optional<Basis> basis_;
};

/// What a journal holds up to its last whole checkpoint.
struct JournalContents {
  std::uint64_t end = 0;  ///< of that checkpoint; the rest is to be dropped
  std::optional<Checkpoint> checkpoint{};
  std::optional<std::string> resolved_case{};  ///< where the run was given another end
};

enum class Thoroughness {
  every_byte,   ///< every record is read and its checksum compared
  checkpoints,  ///< only checkpoints are, which is enough for a look
};

/// Throws SystemError where the file cannot be read, ArchiveError where there is something in it,
/// but no journal, and where a record that was written whole makes no sense.
JournalContents contents_of(const FileDescriptor& journal, Thoroughness thoroughness);

/// What a run has done since its output file was made: an append-only file beside it, locked as
/// long as this lives. An empty one is deleted with this.
///
/// A record takes 16 bytes (kind, CRC-32C, length) and its payload; the checksum covers the header
/// of the journal too, so that a record of a journal before is none of this one. What follows the
/// last whole checkpoint is dropped when the run is resumed. Every function throws SystemError; a
/// record that could not be written is cut off again.
class Journal {
 public:
  /// Opens or creates the journal of `output` and locks it. What is in it stays.
  ///
  /// Throws OutputError where another process holds the lock.
  explicit Journal(const std::filesystem::path& output);
  Journal(Journal&&) = default;
  ~Journal();

  const std::filesystem::path& path() const { return path_; }
  const FileDescriptor& file() const { return file_; }
  std::uint64_t size() const { return size_; }

  /// Drops everything and begins anew. On the disk when it returns.
  void begin(const Basis& basis);
  /// Drops everything but what the journal of the same basis was found to hold.
  void continue_after(const Basis& basis, const JournalContents& contents);
  /// Drops everything.
  void clear();

  void append(const CollisionRows& rows);
  void append(const Snapshot& snapshot);
  /// Both are on the disk when these return.
  void append(const Checkpoint& checkpoint);
  void append(const std::string& resolved_case);

  /// Whether the name still leads to this file.
  bool is_in_place() const;
  /// Deletes the file; the lock goes with it.
  void remove();

 private:
  template <class Payload>
  void append(RecordKind kind, const Payload& payload);
  void write(RecordKind kind, std::span<const std::span<const std::uint8_t>> payload);

  std::filesystem::path path_;
  FileDescriptor file_;
  std::uint64_t size_ = 0;
  std::uint32_t seed_ = 0;  ///< of the checksums of records: the checksum of the header
};

}  // namespace zenosphere
