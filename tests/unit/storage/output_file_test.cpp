#include "storage/output_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <fstream>

#include "storage/hdf5.hpp"
#include "storage/hdf5_series.hpp"
#include "storage/output_info.hpp"
#include "unit/storage/output_fixture.hpp"

namespace zenosphere {
namespace {

TEST_F(OutputFileTest, SnapshotsAreReadBackBitForBit) {
  OutputFile output(path, planar_pair, Existing::refuse);
  write_run(output, 0);
  output.write(snapshot(3));
  finish(output, 3);

  const auto file = hdf5::opened_file(path);
  const auto spheres = hdf5::opened(file, "particles/spheres");
  using Shape = std::vector<std::int64_t>;
  EXPECT_EQ(hdf5::shape(spheres, "position/value"), (Shape{2, 2, 2}));
  EXPECT_EQ(hdf5::shape(spheres, "box/edges/value"), (Shape{2, 2, 2}));
  const double x = 0.1 * 3;
  using Values = std::vector<double>;
  EXPECT_EQ(hdf5::values<double>(spheres, "position/value"), (Values{0, 1, 2, 3, x, 1, 2, 3}));
  EXPECT_EQ(hdf5::values<double>(spheres, "velocity/value"), (Values{-0.0, 5, 6, 7, -x, 5, 6, 7}));
  EXPECT_EQ(hdf5::values<double>(spheres, "box/edges/value"), (Values{8, 0, 0, 8, 8, 0, x, 8}));
  EXPECT_EQ(hdf5::values<std::int32_t>(spheres, "image/value"),
            (std::vector<std::int32_t>{0, 0, 0, 1, 3, 0, -3, 1}));
  for (const std::string element : {"position", "velocity", "image", "box/edges"}) {
    EXPECT_EQ(hdf5::values<std::int64_t>(spheres, element + "/step"), (Shape{0, 3}));
    EXPECT_EQ(hdf5::values<double>(spheres, element + "/time"), (Values{0, x}));
  }
}

TEST_F(OutputFileTest, LogLongerThanItsBufferIsReadBackBitForBit) {
  const std::int64_t rows = 150'000;  // 36 buffers of 4096 and a rest
  OutputFile output(path, planar_pair, Existing::refuse);
  write_run(output, 1000);
  output.checkpoint(checkpoint(1000));  // so that later buffers straddle the chunks of the file
  for (std::int64_t k = 1001; k <= rows; ++k) output.append(row(k));
  finish(output, rows);

  const auto file = hdf5::opened_file(path);
  const auto log = hdf5::opened(file, "collisions");
  const auto k = hdf5::values<std::int64_t>(log, "k");
  const auto time = hdf5::values<double>(log, "time");
  const auto i = hdf5::values<std::int32_t>(log, "i");
  const auto j = hdf5::values<std::int32_t>(log, "j");
  const auto gap = hdf5::values<double>(log, "gap");
  const auto normal_speed = hdf5::values<double>(log, "normal_speed");
  const auto flags = hdf5::values<std::uint8_t>(log, "flags");
  ASSERT_EQ(flags.size(), 150'000u);
  for (std::size_t n = 0; n < flags.size(); ++n) {
    const auto expected = row(static_cast<std::int64_t>(n) + 1);
    ASSERT_EQ(k[n], expected.k);
    ASSERT_EQ(time[n], expected.time);
    ASSERT_EQ(i[n], expected.i);
    ASSERT_EQ(j[n], expected.j);
    ASSERT_EQ(gap[n], expected.gap);
    ASSERT_EQ(normal_speed[n], expected.normal_speed);
    ASSERT_EQ(flags[n], expected.flags);
  }
}

TEST_F(OutputFileTest, FinishedFileTellsCaseSummaryAndCompleteness) {
  OutputFile output(path, planar_pair, Existing::refuse);
  write_run(output, 1);
  finish(output, 1);
  const auto info = read_output_info(path);
  EXPECT_TRUE(info.complete);
  EXPECT_TRUE(info.log_complete);
  EXPECT_EQ(info.case_text, planar_pair.case_text);
  EXPECT_EQ(info.resolved_case, planar_pair.resolved_case);
  EXPECT_EQ(info.summary, to_json(summary_of(1), 2));
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, LogOfSomeOfTheCollisionsIsNotMarkedComplete) {
  OutputFile output(path, planar_pair, Existing::refuse);
  write_run(output, 0);
  output.append(row(7));
  finish(output, 9);
  EXPECT_TRUE(read_output_info(path).complete);
  EXPECT_FALSE(read_output_info(path).log_complete);
}

TEST_F(OutputFileTest, HasNoNameBeforeItBegins) {
  OutputFile output(path, planar_pair, Existing::refuse);
  output.write(snapshot(0));
  EXPECT_FALSE(fs::exists(path));
  output.begin(checkpoint(0));
  EXPECT_EQ(read_output_info(path).snapshots, 1);
  EXPECT_FALSE(read_output_info(path).complete);
}

TEST_F(OutputFileTest, CheckpointCanBeReadWhileTheRunGoesOn) {
  OutputFile output(path, planar_pair, Existing::refuse);
  write_run(output, 5);
  for (const std::int64_t k : {5, 6, 7}) {  // the first in the file, the others in the journal
    if (k > 5) output.append(row(k));
    output.checkpoint(checkpoint(k));
    const auto info = read_output_info(path);
    EXPECT_EQ(info.logged_collisions, k);
    EXPECT_EQ(info.last_collision, k);
    EXPECT_EQ(info.snapshots, 1);
    EXPECT_FALSE(info.complete);
    EXPECT_FALSE(info.log_complete);
  }
}

TEST_F(OutputFileTest, ExistingFileIsRefusedAndStaysAsItWas) {
  std::ofstream(path) << "precious";
  EXPECT_EQ(error_text([&] { OutputFile(path, planar_pair, Existing::refuse); }),
            path.string() +
                ": exists already; choose another name or pass "
                "--overwrite");
  EXPECT_EQ(fs::file_size(path), 8u);
}

TEST_F(OutputFileTest, ReplacingLeavesOneFileWithTheNewRun) {
  std::ofstream(path) << "old";
  OutputFile output(path, planar_pair, Existing::replace);
  EXPECT_EQ(fs::file_size(path), 3u);  // until there is something to put in its place
  write_run(output, 0);
  finish(output, 0);
  EXPECT_TRUE(read_output_info(path).complete);
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, ReplacingThroughALinkReplacesWhatItPointsTo) {
  std::ofstream(path) << "old";
  fs::create_symlink(path, folder.path / "link.h5");
  OutputFile output(folder.path / "link.h5", planar_pair, Existing::replace);
  write_run(output, 0);
  finish(output, 0);
  EXPECT_TRUE(fs::is_symlink(folder.path / "link.h5"));
  EXPECT_TRUE(read_output_info(path).complete);
}

TEST_F(OutputFileTest, ReplacingThatFailsLeavesTheOldFileAndNothingElse) {
  std::ofstream(path) << "precious";
  std::string text;
  {
    const FileSizeLimit limit(4096);  // less than the empty structure takes
    text = error_text([&] { OutputFile(path, planar_pair, Existing::replace); });
  }
  EXPECT_EQ(text, path.string() + ": could not be created (File too large); choose another place");
  EXPECT_EQ(fs::file_size(path), 8u);
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, CreationThatFailsLeavesNothingBehind) {
  {
    const FileSizeLimit limit(4096);
    EXPECT_THROW(OutputFile(path, planar_pair, Existing::refuse), OutputError);
  }
  EXPECT_EQ(files(), 0);
}

TEST_F(OutputFileTest, MissingFolderIsNamed) {
  const auto missing = folder.path / "nowhere";
  const auto file = missing / "out.h5";
  EXPECT_EQ(
      error_text([&] { OutputFile(file, planar_pair, Existing::refuse); }),
      file.string() + ": there is no folder " + missing.string() + "; create it or choose another");
}

TEST_F(OutputFileTest, FolderOrDeviceIsNeverReplaced) {
  EXPECT_EQ(error_text([&] { OutputFile(folder.path, planar_pair, Existing::replace); }),
            folder.path.string() + ": is a folder; choose the name of a file");
  EXPECT_EQ(error_text([&] { OutputFile("/dev/null", planar_pair, Existing::replace); }),
            "/dev/null: is not a regular file; choose another name");
}

TEST_F(OutputFileTest, FileIsNotLockedAgainstReaders) {
  OutputFile output(path, planar_pair, Existing::refuse);
  write_run(output, 0);
  const int reader = open(path.c_str(), O_RDONLY);
  EXPECT_EQ(flock(reader, LOCK_SH | LOCK_NB), 0);  // what HDF5 does on opening to read
  close(reader);
}

}  // namespace
}  // namespace zenosphere
