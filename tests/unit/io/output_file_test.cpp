#include "io/output_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <functional>

#include "io/hdf5.hpp"
#include "io/hdf5_series.hpp"
#include "io/output_reader.hpp"
#include "model/errors.hpp"
#include "unit/io/temporary_folder.hpp"

namespace zenosphere {
namespace {

namespace fs = std::filesystem;
using Existing = OutputFile::Existing;

const OutputFile::Header planar_pair{"a = 1  # \u00b5\n", "a = 1\n", 2, 2};

Snapshot snapshot(std::int64_t step) {
  const double x = 0.1 * static_cast<double>(step);
  return {step, x, {x, 1, 2, 3}, {-x, 5, 6, 7}, {8, 0, x, 8}};
}

CollisionRow row(std::int64_t k) {
  const double x = static_cast<double>(k);
  const auto i = static_cast<std::int32_t>(k);
  return {k, x / 3, i, i + 1, -x / 7, x / 11, static_cast<std::uint8_t>(k % 32)};
}

Summary summary_of(std::int64_t collisions) {
  Summary summary;
  summary.collisions = collisions;
  summary.verdict = "none";
  return summary;
}

std::string error_text(const std::function<void()>& action) {
  try {
    action();
  } catch (const OutputError& error) {
    return error.what();
  }
  return "no OutputError";
}

/// While this lives, no file may grow beyond a size: a full disk for tests.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit before_{};
};

class OutputFileTest : public ::testing::Test {
 protected:
  /// What another process would see: HDF5 shares the state of one file within one process.
  OutputInfo info_of_copy() const {
    fs::copy_file(path, folder.path / "copy.h5", fs::copy_options::overwrite_existing);
    return read_output_info(folder.path / "copy.h5");
  }
  std::ptrdiff_t files() const {
    return std::distance(fs::directory_iterator(folder.path), fs::directory_iterator());
  }

  std::uintmax_t size_with_one_row() const {
    const fs::path other = folder.path / "one_row.h5";
    OutputFile output(other, planar_pair, Existing::refuse);
    output.append(row(1));
    output.flush();
    return fs::file_size(other);
  }

  TemporaryFolder folder;
  fs::path path = folder.path / "out.h5";
};

TEST_F(OutputFileTest, SnapshotsAreReadBackBitForBit) {
  OutputFile output(path, planar_pair, Existing::refuse);
  output.write(snapshot(0));
  output.write(snapshot(3));
  output.finish(summary_of(3));

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
  for (const std::string element : {"position", "velocity", "box/edges"}) {
    EXPECT_EQ(hdf5::values<std::int64_t>(spheres, element + "/step"), (Shape{0, 3}));
    EXPECT_EQ(hdf5::values<double>(spheres, element + "/time"), (Values{0, x}));
  }
}

TEST_F(OutputFileTest, LogLongerThanItsBufferIsReadBackBitForBit) {
  const std::int64_t rows = 150'000;  // two buffers of 65536 and a rest
  OutputFile output(path, planar_pair, Existing::refuse);
  for (std::int64_t k = 1; k <= rows; ++k) {
    output.append(row(k));
    if (k == 1000) output.flush();  // so that later buffers straddle the chunks of the file
  }
  output.finish(summary_of(rows));

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
  output.write(snapshot(0));
  output.append(row(1));
  output.finish(summary_of(1));
  const auto info = read_output_info(path);
  EXPECT_TRUE(info.complete);
  EXPECT_TRUE(info.log_complete);
  EXPECT_EQ(info.case_text, planar_pair.case_text);
  EXPECT_EQ(info.resolved_case, planar_pair.resolved_case);
  EXPECT_EQ(info.summary, to_json(summary_of(1), 2));
}

TEST_F(OutputFileTest, LogOfSomeOfTheCollisionsIsNotMarkedComplete) {
  OutputFile output(path, planar_pair, Existing::refuse);
  output.append(row(7));
  output.finish(summary_of(9));
  EXPECT_TRUE(read_output_info(path).complete);
  EXPECT_FALSE(read_output_info(path).log_complete);
}

TEST_F(OutputFileTest, FlushedRowsAreReadableWhileTheRunGoesOn) {
  OutputFile output(path, planar_pair, Existing::refuse);
  output.write(snapshot(0));
  for (std::int64_t k = 1; k <= 5; ++k) output.append(row(k));
  output.flush();
  output.append(row(6));
  const auto info = info_of_copy();
  EXPECT_EQ(info.logged_collisions, 5);
  EXPECT_EQ(info.snapshots, 1);
  EXPECT_FALSE(info.complete);
}

TEST_F(OutputFileTest, UnfinishedFileKeepsEverythingAndIsIncomplete) {
  {
    OutputFile output(path, planar_pair, Existing::refuse);
    output.write(snapshot(0));
    output.append(row(1));
  }
  const auto info = read_output_info(path);
  EXPECT_EQ(info.logged_collisions, 1);
  EXPECT_EQ(info.snapshots, 1);
  EXPECT_FALSE(info.complete);
  EXPECT_FALSE(info.log_complete);
  EXPECT_FALSE(info.summary.has_value());
}

TEST_F(OutputFileTest, ExistingFileIsRefusedAndStaysAsItWas) {
  std::ofstream(path) << "precious";
  EXPECT_EQ(error_text([&] { OutputFile(path, planar_pair, Existing::refuse); }),
            path.string() +
                ": exists already (a run's data may be in it); choose another name or pass "
                "--overwrite");
  EXPECT_EQ(fs::file_size(path), 8u);
}

TEST_F(OutputFileTest, ReplacingLeavesOneFileWithTheNewRun) {
  std::ofstream(path) << "old";
  OutputFile(path, planar_pair, Existing::replace).finish(summary_of(0));
  EXPECT_TRUE(read_output_info(path).complete);
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, ReplacingThroughALinkReplacesWhatItPointsTo) {
  std::ofstream(path) << "old";
  fs::create_symlink(path, folder.path / "link.h5");
  OutputFile(folder.path / "link.h5", planar_pair, Existing::replace).finish(summary_of(0));
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

TEST_F(OutputFileTest, FullDiskIsReportedWithItsReasonAndFlushedRowsStayReadable) {
  std::string text;
  {
    OutputFile output(path, planar_pair, Existing::refuse);
    output.write(snapshot(0));
    output.append(row(1));
    output.flush();
    const FileSizeLimit limit(2'000'000);  // the flushed file takes 0.9 MB, a buffer 2.7 MB more
    text = error_text([&] {
      for (std::int64_t k = 2; k <= 200'000; ++k) output.append(row(k));
    });
  }
  EXPECT_EQ(text, path.string() +
                      ": could not be written (File too large); it holds what was flushed before, "
                      "choose another place");
  const auto info = info_of_copy();
  EXPECT_EQ(info.logged_collisions, 1);
  EXPECT_EQ(info.snapshots, 1);
  EXPECT_FALSE(info.complete);
}

TEST_F(OutputFileTest, FlushThatTheDiskRefusesLeavesTheFlushBefore) {
  std::string text;
  {
    OutputFile output(path, planar_pair, Existing::refuse);
    output.flush();
    output.append(row(1));
    // The row itself fits below the limit, the chunk of its last column does not: HDF5 would
    // write a size into the file that it then cannot give it.
    const FileSizeLimit limit(size_with_one_row() - 1);
    text = error_text([&] { output.flush(); });
  }
  EXPECT_NE(text.find("(File too large)"), std::string::npos) << text;
  EXPECT_EQ(info_of_copy().logged_collisions, 0);
}

TEST_F(OutputFileTest, FileIsNotLockedAgainstReaders) {
  const OutputFile output(path, planar_pair, Existing::refuse);
  const int reader = open(path.c_str(), O_RDONLY);
  EXPECT_EQ(flock(reader, LOCK_SH | LOCK_NB), 0);  // what HDF5 does on opening to read
  close(reader);
}

}  // namespace
}  // namespace zenosphere
