#include <gtest/gtest.h>

#include "storage/hdf5.hpp"
#include "storage/hdf5_series.hpp"
#include "storage/output_file.hpp"
#include "storage/output_info.hpp"
#include "storage/recovery.hpp"
#include "storage/stored_info.hpp"
#include "unit/storage/output_fixture.hpp"

namespace zenosphere {
namespace {

using OutputRecovery = OutputFileTest;

TEST_F(OutputRecovery, UnfinishedOutputKeepsItsLastCheckpointAndNothingElse) {
  for (const std::int64_t checkpoints : {0, 1, 2}) {
    {
      OutputFile output(path, planar_pair, Existing::replace);
      write_run(output, 0);
      for (std::int64_t k = 1; k <= checkpoints; ++k) {
        output.append(row(k));
        output.checkpoint(checkpoint(k));
      }
      output.append(row(checkpoints + 1));
      output.write(snapshot(3));
    }
    const auto recovered = recover(path);
    EXPECT_EQ(recovered.checkpoint.collisions, checkpoints);
    EXPECT_EQ(recovered.checkpoint.log_rows, checkpoints);
    EXPECT_EQ(recovered.checkpoint.snapshots, 1);
    EXPECT_EQ(recovered.checkpoint.state, checkpoint(checkpoints).state);
    EXPECT_FALSE(recovered.info.summary.has_value());
  }
}

TEST_F(OutputRecovery, ResumedOutputHoldsWhatOneThatRanThroughHolds) {
  for (const std::int64_t cut_off : {0, 1, 40, 41, 99}) {
    const fs::path resumed = folder.path / "resumed.h5";
    {
      OutputFile output(resumed, planar_pair, Existing::replace);
      write_run(output, cut_off);
      if (cut_off >= 40) output.checkpoint(checkpoint(cut_off));
    }
    const std::int64_t kept = cut_off >= 40 ? cut_off : 0;
    OutputFile output(recover(resumed));
    output.go_on(planar_pair.resolved_case);
    for (std::int64_t k = kept + 1; k <= 100; ++k) output.append(row(k));
    finish(output, 100);
    const auto k = hdf5::values<std::int64_t>(hdf5::opened_file(resumed), "collisions/k");
    ASSERT_EQ(k.size(), 100u);
    for (std::size_t n = 0; n < k.size(); ++n) ASSERT_EQ(k[n], static_cast<std::int64_t>(n) + 1);
    EXPECT_TRUE(read_output_info(resumed).log_complete);
    fs::remove(resumed);
  }
}

TEST_F(OutputRecovery, ExtensionTakesBackTheEndOfTheRunBefore) {
  {
    OutputFile output(path, planar_pair, Existing::refuse);
    write_run(output, 3);
    output.end(checkpoint(3));
    output.append(row(4));      // the row that waited for its next gap, which never came
    output.write(snapshot(3));  // and the last state
    output.finish(summary_of(4));
  }
  OutputFile output(recover(path));
  output.go_on("a = 2\n");
  EXPECT_TRUE(read_output_info(path).complete);  // until the longer run is there
  output.append(row(5));
  finish(output, 4);
  const auto info = read_output_info(path);
  EXPECT_EQ(info.resolved_case, "a = 2\n");
  EXPECT_EQ(info.snapshots, 1);
  const auto k = hdf5::values<std::int64_t>(hdf5::opened_file(path), "collisions/k");
  EXPECT_EQ(k, (std::vector<std::int64_t>{1, 2, 3, 5}));
}

TEST_F(OutputRecovery, JournalThatHasOutgrownTheFileIsFoldedIn) {
  const fs::path journal = path.string() + ".journal";
  Checkpoint large = checkpoint(2);
  large.state.resize(65 << 20);  // a journal up to 64 MiB is left alone
  OutputFile output(path, planar_pair, Existing::refuse);
  write_run(output, 1);
  output.checkpoint(checkpoint(1));
  output.append(row(2));
  output.fold_if_due();
  EXPECT_EQ(hdf5::shape(hdf5::opened_file(path), "collisions/k").front(), 1);
  output.checkpoint(large);
  EXPECT_GT(fs::file_size(journal), 65u << 20);
  output.fold_if_due();
  EXPECT_LT(fs::file_size(journal), 100u);
  EXPECT_EQ(hdf5::shape(hdf5::opened_file(path), "collisions/k").front(), 2);
  EXPECT_EQ(read_checkpoint(path).state, large.state);
  output.append(row(3));
  finish(output, 3);
  EXPECT_TRUE(read_output_info(path).log_complete);
}

TEST_F(OutputRecovery, OutputThatIsBeingWrittenIsLocked) {
  OutputFile output(path, planar_pair, Existing::refuse);
  write_run(output, 0);
  const std::string problem = path.string() +
                              ".journal: is locked (another run writes this output); wait until it "
                              "has ended, or choose another output";
  EXPECT_EQ(error_text([&] { recover(path); }), problem);
  EXPECT_EQ(error_text([&] { OutputFile(path, planar_pair, Existing::replace); }), problem);
}

TEST_F(OutputRecovery, DeletedOutputIsNoticedAtTheNextCheckpoint) {
  const auto problem_after = [&](const std::function<void()>& mishap) {
    OutputFile output(path, planar_pair, Existing::replace);
    write_run(output, 1);
    output.checkpoint(checkpoint(1));
    mishap();
    return error_text([&] { output.checkpoint(checkpoint(1)); });
  };
  for (const std::string suffix : {"", ".journal"}) {
    const auto text = problem_after([&] { fs::remove(path.string() + suffix); });
    EXPECT_NE(text.find("no longer there"), std::string::npos) << text;
  }
  const auto text = problem_after([&] { fs::remove_all(folder.path); });
  EXPECT_NE(text.find("no longer there"), std::string::npos) << text;
}

TEST_F(OutputRecovery, JournalWithoutItsOutputIsRefused) {
  {
    OutputFile output(path, planar_pair, Existing::refuse);
    write_run(output, 1);
    output.checkpoint(checkpoint(1));
  }
  fs::rename(path, folder.path / "moved.h5");
  EXPECT_EQ(error_text([&] { OutputFile(path, planar_pair, Existing::refuse); }),
            path.string() +
                ".journal: belongs to a run whose out.h5 is not here (moved or deleted?); put them "
                "together again, or delete it");
}

TEST_F(OutputRecovery, FullDiskIsReportedWithItsReasonAndTheCheckpointStays) {
  for (const std::int64_t checkpoints : {0, 1, 2}) {  // none, in the file, in the journal
    std::string text;
    {
      OutputFile output(path, planar_pair, Existing::replace);
      write_run(output, 1);
      for (std::int64_t k = 0; k < checkpoints; ++k) output.checkpoint(checkpoint(1));
      const FileSizeLimit limit(2'000'000);  // the file takes 0.9 MB, a buffer 2.7 MB more
      text = error_text([&] {
        for (std::int64_t k = 2; k <= 200'000; ++k) output.append(row(k));
      });
    }
    const std::string kept = checkpoints == 0 ? "0 (time 0)" : "1 (time 0.1)";
    EXPECT_EQ(text, path.string() +
                        ": could not be written (File too large); everything up to collision " +
                        kept + " is kept: mend that, then zenosphere resume " + path.string());
    const auto info = read_output_info(path);
    EXPECT_EQ(info.logged_collisions, checkpoints == 0 ? 0 : 1);
    EXPECT_EQ(info.snapshots, 1);
    EXPECT_FALSE(info.complete);
    EXPECT_EQ(recover(path).checkpoint.collisions, checkpoints == 0 ? 0 : 1);
    EXPECT_FALSE(fs::exists(path.string() + ".part"));
  }
}

TEST_F(OutputRecovery, EndThatDoesNotFitOnTheDiskIsFinishedLater) {
  {
    OutputFile output(path, planar_pair, Existing::refuse);
    write_run(output, 1);
    output.checkpoint(checkpoint(1));
    output.append(row(2));
    output.end(checkpoint(2));
    const FileSizeLimit limit(100'000);
    EXPECT_THROW(output.finish(summary_of(2)), OutputError);
  }
  OutputFile output(recover(path));
  output.go_on(planar_pair.resolved_case);
  finish(output, 2);
  EXPECT_TRUE(read_output_info(path).log_complete);
  EXPECT_EQ(files(), 1);
}

}  // namespace
}  // namespace zenosphere
