#include "storage/output_info.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "model/errors.hpp"
#include "storage/build_info.hpp"
#include "storage/hdf5.hpp"
#include "storage/output_datasets.hpp"
#include "unit/storage/temporary_folder.hpp"

namespace zenosphere {
namespace {

namespace fs = std::filesystem;

class OutputInfoTest : public ::testing::Test {
 protected:
  /// The part of the error behind the name of the file.
  std::string problem() const {
    try {
      read_output_info(path);
    } catch (const InputError& error) {
      const std::string text = error.what();
      EXPECT_EQ(text.find(path.string() + ": "), 0u) << text;
      return text.substr(std::min(text.size(), path.string().size() + 2));
    }
    return "no InputError";
  }
  void write_run(const std::vector<CollisionRow>& rows) const {
    OutputDatasets output(path, {"case", "resolved", 1, 3});
    output.append(Snapshot{0, 0, {0, 1, 2}, {3, 4, 5}, {6}, {0, 0, 0}});
    output.append(Snapshot{4, 0.5, {0, 1, 2}, {3, 4, 5}, {6}, {0, 0, 0}});
    CollisionRows columns;
    for (const auto& row : rows) columns.append(row);
    output.append(columns);
    output.close();
  }

  TemporaryFolder folder;
  fs::path path = folder.path / "out.h5";
};

TEST_F(OutputInfoTest, TellsExtentsAndProvenance) {
  write_run({});
  const auto info = read_output_info(path);
  EXPECT_EQ(info.format_version, 1);
  EXPECT_EQ(info.program_version, build_info::program_version);
  EXPECT_EQ(info.git_hash, build_info::git_hash);
  EXPECT_EQ(info.compiler, build_info::compiler);
  EXPECT_EQ(info.compiler_flags, build_info::compiler_flags);
  EXPECT_EQ(info.case_text, "case");
  EXPECT_EQ(info.resolved_case, "resolved");
  EXPECT_EQ(info.dimension, 1);
  EXPECT_EQ(info.spheres, 3);
  EXPECT_EQ(info.snapshots, 2);
  EXPECT_EQ(info.logged_collisions, 0);
}

TEST_F(OutputInfoTest, EndIsTheLastSnapshotOrTheLastLoggedCollisionWhicheverIsFarther) {
  write_run({{3, 0.25, 0, 1, 1, 1, 0}});
  EXPECT_EQ(read_output_info(path).last_collision, 4);
  EXPECT_EQ(read_output_info(path).last_time, 0.5);
  fs::remove(path);
  write_run({{3, 0.25, 0, 1, 1, 1, 0}, {9, 0.75, 0, 1, 1, 1, 0}});
  EXPECT_EQ(read_output_info(path).last_collision, 9);
  EXPECT_EQ(read_output_info(path).last_time, 0.75);
}

TEST_F(OutputInfoTest, RejectsWhatIsNotThere) {
  EXPECT_EQ(problem(), "does not exist; name an output file of a run");
}

TEST_F(OutputInfoTest, RejectsAFolder) {
  fs::create_directory(path);
  EXPECT_EQ(problem(), "is a folder; name an output file of a run");
}

TEST_F(OutputInfoTest, RejectsWhatIsNotHdf5) {
  std::ofstream(path) << "some text\n";
  EXPECT_EQ(problem(), "is not an HDF5 file; name an output file of a run");
}

TEST_F(OutputInfoTest, RejectsHdf5OfAnotherProgram) {
  hdf5::created_group(hdf5::created_file(path), "particles");
  EXPECT_EQ(problem(), "has no group /zenosphere (it is not an output of this program)");
}

TEST_F(OutputInfoTest, RejectsANewerFormatAndNamesTheProgramThatReadsIt) {
  const auto write = [this] {
    const auto file = hdf5::created_file(path);
    const auto own = hdf5::created_group(file, "zenosphere");
    hdf5::write_attribute(own, "format_version", std::int64_t{2});
    hdf5::write_attribute(own, "program_version", "7.5.0");
  };
  write();
  EXPECT_EQ(problem(),
            "has format version 2 (this program reads up to 1); use zenosphere 7.5.0, which wrote "
            "it, or newer");
}

TEST_F(OutputInfoTest, TellsWhatIsWrongWithADamagedFile) {
  write_run({});
  fs::resize_file(path, fs::file_size(path) / 2);
  EXPECT_NE(problem().find("cannot be read (truncated file"), std::string::npos) << problem();
}

TEST_F(OutputInfoTest, RejectsAProgramVersionThatIsNoText) {
  write_run({});
  const auto write = [this] {
    const auto own = hdf5::opened(hdf5::reopened_file(path), "zenosphere");
    hdf5::write_attribute(own, "git_hash", "\xF1");
  };
  write();
  EXPECT_NE(problem().find("a program version that is no plain text"), std::string::npos);
}

TEST_F(OutputInfoTest, TellsWhatIsMissingInAnIncompleteStructure) {
  const auto write = [this] {
    const auto file = hdf5::created_file(path);
    const auto own = hdf5::created_group(file, "zenosphere");
    hdf5::write_attribute(own, "format_version", "one");
  };
  write();
  EXPECT_NE(problem().find("cannot be read ("), std::string::npos) << problem();
}

}  // namespace
}  // namespace zenosphere
