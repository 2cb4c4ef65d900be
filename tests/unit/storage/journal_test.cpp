#include "storage/journal.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>

#include <fstream>

#include "model/errors.hpp"
#include "storage/checksum.hpp"
#include "unit/storage/temporary_folder.hpp"

namespace zenosphere {
namespace {

namespace fs = std::filesystem;

Checkpoint journal_checkpoint(std::int64_t collisions) {
  Checkpoint checkpoint;
  checkpoint.collisions = collisions;
  checkpoint.log_rows = collisions;
  checkpoint.state = {9, 8, static_cast<std::uint8_t>(collisions)};
  return checkpoint;
}

CollisionRows rows(std::int64_t first, std::int64_t count) {
  CollisionRows rows;
  for (std::int64_t k = first; k < first + count; ++k) rows.append({k, 0.5, 1, 2, 0.25, 3, 4});
  return rows;
}

class JournalTest : public ::testing::Test {
 protected:
  /// Three collisions, a checkpoint, two more, a snapshot, a checkpoint, and one collision too
  /// many.
  void write_journal() {
    Journal journal(output);
    journal.begin(basis);
    journal.append(rows(1, 3));
    journal.append(journal_checkpoint(3));
    first_end = journal.size();
    journal.append(rows(4, 2));
    journal.append(Snapshot{5, 1.5, {1}, {2}, {3}});
    journal.append(journal_checkpoint(5));
    second_end = journal.size();
    journal.append(rows(6, 1));
  }

  Bytes bytes() const {
    const FileDescriptor file(journal_of(output), O_RDONLY);
    return read_at(file, 0, static_cast<std::size_t>(size_of(file)));
  }
  JournalContents contents(const Bytes& of) const {
    std::ofstream(copy, std::ios::binary)
        .write(reinterpret_cast<const char*>(of.data()), static_cast<std::streamsize>(of.size()));
    return contents_of(FileDescriptor(copy, O_RDONLY), Thoroughness::every_byte);
  }

  TemporaryFolder folder;
  fs::path output = folder.path / "out.h5";
  fs::path copy = folder.path / "copy";
  Basis basis = Basis::of(journal_checkpoint(0));
  std::uint64_t first_end = 0;
  std::uint64_t second_end = 0;
};

TEST(CollisionLog, HasTheColumnsOfItsVersion) {
  std::string names;
  CollisionRows::fields(CollisionRows(), [&](const char* name, const auto&, auto) {
    names += (names.empty() ? "" : " ") + std::string(name);
  });
  EXPECT_EQ(log_version, 1u);  // where columns have changed, raise it and write them down here
  EXPECT_EQ(names, "k time i j gap normal_speed flags");
}

TEST(Checksum, IsTheCastagnoliPolynomial) {
  const Bytes digits{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  EXPECT_EQ(checksum(digits), 0xe3069283u);        // the check value of CRC-32C
  EXPECT_EQ(checksum(Bytes(32, 0)), 0x8a9136aau);  // RFC 3720, B.4
  EXPECT_EQ(checksum(Bytes(32, 0xff)), 0x62a8ab43u);
}

TEST(Checksum, OfPartsIsThatOfTheWhole) {
  Bytes bytes(100);
  for (std::size_t k = 0; k < bytes.size(); ++k) bytes[k] = static_cast<std::uint8_t>(k * 37);
  const std::span<const std::uint8_t> whole(bytes);
  for (std::size_t k = 0; k <= bytes.size(); ++k) {
    EXPECT_EQ(checksum(whole.subspan(k), checksum(whole.first(k))), checksum(whole));
  }
}

TEST_F(JournalTest, RecordsAreReadBackInOrder) {
  write_journal();
  const FileDescriptor file(journal_of(output), O_RDONLY);
  JournalReader reader(file);
  EXPECT_EQ(reader.basis(), basis);
  std::vector<RecordKind> kinds;
  while (const auto record = reader.next()) {
    kinds.push_back(record->kind);
    const Bytes payload = reader.payload(*record);
    ArchiveReader archive(payload);
    if (record->kind == RecordKind::rows) {
      EXPECT_EQ(archive.next<CollisionRows>().gap.back(), 0.25);
    }
    if (record->kind == RecordKind::snapshot) {
      const auto snapshot = archive.next<Snapshot>();
      EXPECT_EQ(snapshot.step, 5);
      EXPECT_EQ(snapshot.box_edges, std::vector<double>{3});
    }
  }
  using enum RecordKind;
  EXPECT_EQ(kinds, (std::vector{rows, RecordKind::checkpoint, rows, snapshot,
                                RecordKind::checkpoint, rows}));
}

TEST_F(JournalTest, TornAtAnyByteItHoldsTheLastCheckpointBefore) {
  write_journal();
  const Bytes whole = bytes();
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    const auto found = contents({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)});
    const std::int64_t expected = size >= second_end ? 5 : size >= first_end ? 3 : 0;
    ASSERT_EQ(found.checkpoint ? found.checkpoint->collisions : 0, expected) << size;
    if (expected == 0) continue;
    ASSERT_EQ(found.end, expected == 5 ? second_end : first_end) << size;
  }
}

TEST_F(JournalTest, FlippedBitCostsTheCheckpointsBehindItAndNoOthers) {
  write_journal();
  const Bytes whole = bytes();
  const std::size_t header = 52;
  for (std::size_t place = header; place < whole.size(); ++place) {
    Bytes damaged = whole;
    damaged[place] = static_cast<std::uint8_t>(damaged[place] ^ (1U << (place % 8)));
    const auto found = contents(damaged);
    const std::int64_t expected = place >= second_end ? 5 : place >= first_end ? 3 : 0;
    ASSERT_EQ(found.checkpoint ? found.checkpoint->collisions : 0, expected) << place;
  }
}

TEST_F(JournalTest, DamagedHeaderIsAnErrorAndNotAnEmptyJournal) {
  write_journal();
  for (std::size_t place = 0; place < 52; ++place) {
    Bytes damaged = bytes();
    damaged[place] = static_cast<std::uint8_t>(damaged[place] ^ 4);
    EXPECT_THROW(contents(damaged), ArchiveError) << place;
  }
}

TEST_F(JournalTest, RecordOfAnEarlierJournalIsNoneOfThisOne) {
  write_journal();
  const Bytes old = bytes();
  Journal journal(output);
  journal.begin(Basis::of(journal_checkpoint(5)));
  Bytes mixed = bytes();
  mixed.insert(mixed.end(), old.begin() + static_cast<std::ptrdiff_t>(mixed.size()), old.end());
  EXPECT_FALSE(contents(mixed).checkpoint);
}

TEST_F(JournalTest, NewEndOfTheRunCountsAtOnceAndStays) {
  Journal journal(output);
  journal.begin(basis);
  journal.append(std::string("a = 1\n"));
  EXPECT_EQ(contents(bytes()).resolved_case, "a = 1\n");
  EXPECT_EQ(contents(bytes()).end, journal.size());
  journal.append(rows(1, 1));
  journal.append(journal_checkpoint(1));
  EXPECT_EQ(contents(bytes()).resolved_case, "a = 1\n");
}

TEST_F(JournalTest, GoesOnBehindWhatWasFound) {
  write_journal();
  {
    Journal journal(output);
    journal.continue_after(basis, contents(bytes()));
    EXPECT_EQ(journal.size(), second_end);
    journal.append(rows(6, 2));
    journal.append(journal_checkpoint(7));
  }
  EXPECT_EQ(contents(bytes()).checkpoint->collisions, 7);
}

TEST_F(JournalTest, SecondOwnerIsRefused) {
  const Journal journal(output);
  EXPECT_THROW(Journal{output}, OutputError);
}

TEST_F(JournalTest, EmptyOneIsDeletedAndAFullOneStays) {
  { const Journal journal(output); }
  EXPECT_FALSE(fs::exists(journal_of(output)));
  write_journal();
  { const Journal journal(output); }
  EXPECT_TRUE(fs::exists(journal_of(output)));
}

}  // namespace
}  // namespace zenosphere
