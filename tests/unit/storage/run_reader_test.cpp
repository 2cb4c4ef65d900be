#include "storage/run_reader.hpp"

#include "unit/storage/output_fixture.hpp"

namespace zenosphere {
namespace {

using RunReaderTest = OutputFileTest;

std::vector<std::int64_t> numbers_in(const RunReader& run) {
  std::vector<std::int64_t> numbers;
  for (std::int64_t n = 0; n < run.log_pieces(); ++n) {
    for (const CollisionRow& row : run.log_piece(n)) numbers.push_back(row.k);
  }
  return numbers;
}

/// A run that is still open: 3 rows and a snapshot in the file, 2 rows and a snapshot in its
/// journal, and a row that no checkpoint covers.
void leave_unfinished(OutputFile& output) {
  write_run(output, 3);
  output.checkpoint(checkpoint(3));
  output.append(row(4));
  output.append(row(5));
  output.write(snapshot(5));
  output.checkpoint(checkpoint(5));
  output.append(row(6));
  output.write(snapshot(6));
}

TEST_F(RunReaderTest, GoesOnInTheJournalUpToItsLastCheckpoint) {
  OutputFile output(path, planar_pair, Existing::refuse);
  leave_unfinished(output);
  const RunReader run(path);
  EXPECT_EQ(run.info().logged_collisions, 5);
  EXPECT_EQ(run.info().last_collision, 5);
  EXPECT_EQ(run.info().last_time, checkpoint(5).time);
  EXPECT_FALSE(run.info().has_ended());
  ASSERT_EQ(run.snapshots(), 2);
  EXPECT_EQ(run.snapshot(0).step, 0);
  EXPECT_EQ(run.snapshot(1).step, 5);
  EXPECT_EQ(run.snapshot(1).positions, snapshot(5).positions);
  EXPECT_EQ(numbers_in(run), (std::vector<std::int64_t>{1, 2, 3, 4, 5}));
}

TEST_F(RunReaderTest, FinishedRunIsInItsFile) {
  {
    OutputFile output(path, planar_pair, Existing::refuse);
    write_run(output, 3);
    output.write(snapshot(3));
    finish(output, 3);
  }
  const RunReader run(path);
  EXPECT_TRUE(run.info().has_ended());
  EXPECT_EQ(run.snapshots(), 2);
  EXPECT_EQ(numbers_in(run), (std::vector<std::int64_t>{1, 2, 3}));
}

TEST_F(RunReaderTest, LongerRunTakesTheEndOfTheShorterBack) {
  {
    OutputFile output(path, planar_pair, Existing::refuse);
    write_run(output, 3);
    output.end(checkpoint(3));
    output.append(row(40));  // what is written because the run ends
    output.write(snapshot(40));
    output.finish(summary_of(3));
  }
  EXPECT_EQ(numbers_in(RunReader(path)), (std::vector<std::int64_t>{1, 2, 3, 40}));
  OutputFile output(recover(path));
  output.go_on(planar_pair.resolved_case);
  output.append(row(4));
  output.write(snapshot(4));
  output.checkpoint(checkpoint(4));
  const RunReader run(path);
  EXPECT_TRUE(run.info().complete);  // the shorter one
  EXPECT_FALSE(run.info().has_ended());
  EXPECT_EQ(run.info().last_time, checkpoint(4).time);
  EXPECT_EQ(numbers_in(run), (std::vector<std::int64_t>{1, 2, 3, 4}));
  ASSERT_EQ(run.snapshots(), 2);
  EXPECT_EQ(run.snapshot(1).step, 4);
}

TEST_F(RunReaderTest, LogComesInPiecesWithoutAGap) {
  {
    OutputFile output(path, planar_pair, Existing::refuse);
    write_run(output, 70000);
    finish(output, 70000);
  }
  const RunReader run(path);
  EXPECT_EQ(run.log_pieces(), 2);
  const auto numbers = numbers_in(run);
  ASSERT_EQ(numbers.size(), 70000);
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    ASSERT_EQ(numbers[n], static_cast<std::int64_t>(n) + 1);
  }
}

TEST_F(RunReaderTest, JournalOfAnotherRunIsLeftAlone) {
  const fs::path other = folder.path / "other.h5";
  {
    OutputFile output(other, planar_pair, Existing::refuse);
    write_run(output, 7);
    finish(output, 7);
  }
  OutputFile output(path, planar_pair, Existing::refuse);
  leave_unfinished(output);
  fs::copy_file(journal_of(path), journal_of(other));
  EXPECT_EQ(numbers_in(RunReader(other)).size(), 7);
}

TEST_F(RunReaderTest, JournalThatIsClearedMeanwhileIsAnError) {
  OutputFile output(path, planar_pair, Existing::refuse);
  leave_unfinished(output);
  const RunReader run(path);
  fs::resize_file(journal_of(path), 0);
  EXPECT_THROW(run.snapshot(1), InputError);
  EXPECT_EQ(run.snapshot(0).step, 0);
}

}  // namespace
}  // namespace zenosphere
