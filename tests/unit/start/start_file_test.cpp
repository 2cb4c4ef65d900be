#include "start/start_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "storage/output_file.hpp"
#include "unit/start/start_fixture.hpp"

namespace zenosphere {
namespace {

/// The disks in an output file.
class StartOutput : public StartFile {
 protected:
  void write_output(const std::vector<double>& edges, const std::vector<double>& velocities) const {
    OutputFile output(file, {"case", "resolved", 2, 2}, Existing::replace);
    output.write({0, 0, {2, 2, 6, 6}, {9, 9, 9, 9}, {10, 0, 0, 8}, {0, 0, 0, 0}});
    output.write({4, 0.5, {1, 1, 4, 1}, velocities, edges, {0, 0, 1, 0}});
    output.begin({});
  }
};

TEST_F(StartFile, WithoutVelocitiesNeedsATemperature) {
  EXPECT_EQ(problem_of("2\nLattice=\"10 0 0 0 8 0 0 0 1\"\nA 1 1 0\nA 4 1 0\n"),
            "start: has no velocities (a column velo:R:3); add them or start.granular_temperature");
  EXPECT_EQ(problem({"start.granular_temperature=1"}), "");
}

TEST_F(StartFile, WithSpeedsBeyondTheRangeOfTheirProductsIsRefused) {
  EXPECT_EQ(problem_of(xyz_header + "A 1 1 0 0 0 0\nA 4 1 0 0 -1e155 0\n"),
            "start: the fastest sphere, 1, has a velocity of -1e+155; must be 0 or in [1e-75, "
            "1e+75]; choose another unit of time");
}

TEST_F(StartFile, WithSpeedsWhoseDigitsTheDriveLeavesIsNeeded) {
  // 1 and -1 along x: a thermal speed of sqrt(1/2); 0.01 x 0.707 / 2^-52 = 3.18e13.
  write(xyz_header + "A 1 1 0 1 0 0\nA 4 1 0 -1 0 0\n");
  EXPECT_EQ(problem({"gravity.acceleration=[0, 1]", "run.time=3.1e13"}), "");
  EXPECT_EQ(problem({"gravity.acceleration=[0, 1]", "run.time=1e14"}),
            "start: its velocities are not for gravity.acceleration (all fall at 1e+14 "
            "diameters/time at run.time, which is rounded to 0.022 in double; the thermal speed is "
            "0.707); end the run earlier or use more digits in collision.precision");
}

TEST_F(StartFile, WithSpheresThatOverlapNamesThem) {
  EXPECT_EQ(problem_of(xyz_header + "A 1 1 0 1 0 0\nA 1.5 1 0 0 0 0\n"),
            "start: spheres 0 and 1 overlap (distance 0.5 diameters); move them apart");
}

TEST_F(StartFile, InWhichNothingMovesNeedsADrive) {
  EXPECT_EQ(problem_of(xyz_header + "A 1 1 0 0 0 0\nA 4 1 0 0 0 0\n"),
            "start: all velocities are 0 (nothing would ever move); add "
            "start.granular_temperature or drive the spheres");
  EXPECT_EQ(problem({"gravity.acceleration=[0, 1]"}), "");
}

TEST_F(StartFile, ThatCannotBeOpenedIsAnInputError) {
  EXPECT_EQ(problem(),
            "start: cannot be opened (No such file or directory); check the name and its "
            "permissions");
  std::filesystem::create_directory(file);
  EXPECT_EQ(problem(), "start: is a directory; name the file in it");
  std::filesystem::remove(file);
  ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
  EXPECT_EQ(problem(), "start: is not a regular file (it is read twice); copy it to one");
}

TEST_F(StartOutput, GivesItsLastSnapshot) {
  write_output({10, 0, 1e-13, 8}, {1, 0.5, 0, 0});
  const GivenStart start = given_start(case_with());
  EXPECT_EQ(start.positions, (std::vector<double>{1, 1, 4, 1}));
  EXPECT_EQ(start.velocities, (std::vector<double>{1, 0.5, 0, 0}));
  EXPECT_EQ(start.sides, (std::vector<double>{10, 8}));
}

TEST_F(StartOutput, OfAnotherSystemIsRejected) {
  write_output({10, 0, 0, 8}, {1, 0.5, 0, 0});
  EXPECT_EQ(problem({"system.spheres=3"}),
            "start: has 2 spheres (system.spheres = 3); make them equal");
  EXPECT_EQ(problem({"system.dimension=3", "system.sides=[10, 8, 8]"}),
            "start: has 2 dimensions (system.dimension = 3); make them equal");
  EXPECT_EQ(problem({"system.sides=[8, 8]"}),
            "start: has a box of 10 x 8 diameters (that of the case is 8 x 8); make them equal "
            "with system.sides");
}

TEST_F(StartOutput, GivesTheSnapshotThatIsChosen) {
  write_output({10, 0, 0, 8}, {1, 0.5, 0, 0});
  EXPECT_EQ(given_start(case_with({"start.snapshot=0"})).positions,
            (std::vector<double>{2, 2, 6, 6}));
  EXPECT_EQ(given_start(case_with({"start.snapshot=1"})).positions,
            (std::vector<double>{1, 1, 4, 1}));
  EXPECT_EQ(problem({"start.snapshot=2"}),
            "start: has 2 snapshots (start.snapshot = 2, counted from 0); choose one of them");
}

TEST_F(StartOutput, KeepsTheOffsetOfItsImages) {
  write_output({10, 0, 2.5, 8}, {1, 0.5, 0, 0});
  const GivenStart start = given_start(case_with());
  EXPECT_EQ(start.offset, 2.5);
  EXPECT_EQ(start.positions, (std::vector<double>{1, 1, 4, 1}));
  write_output({10, 0, 7.5, 8}, {1, 0.5, 0, 0});  // another offset of the same images
  EXPECT_EQ(given_start(case_with()).offset, -2.5);
}

TEST_F(StartOutput, WithSpheresThatOverlapWhereTheImagesAreDisplacedIsRejected) {
  // Disk 0 at (2, 7.75) has an image at (2 - offset, -0.25): on disk 1 at (6, 0.25) for -4.
  const auto write_pair = [&](double offset) {
    OutputFile output(file, {"case", "resolved", 2, 2}, Existing::replace);
    output.write({0, 0, {2, 7.75, 6, 0.25}, {1, 0, 0, 0}, {10, 0, offset, 8}, {0, 0, 0, 0}});
    output.begin({});
  };
  write_pair(0);
  EXPECT_EQ(problem(), "");
  write_pair(-4);
  EXPECT_EQ(problem(), "start: spheres 0 and 1 overlap (distance 0.5 diameters); move them apart");
}

TEST_F(StartOutput, OfADisplacedBoxHasNoPlaceBetweenWallsAcrossIt) {
  write_output({10, 0, 2.5, 8}, {1, 0.5, 0, 0});
  EXPECT_EQ(problem({"walls.axis=y", "walls.restitution=1"}),
            "start: its images are displaced along x by 2.5 diameters (the case has [walls] along "
            "y); take the walls out, or start from an upright box");
}

TEST_F(StartOutput, OfABoxThatLeansOtherwiseIsRejected) {
  write_output({10, 1, 0, 8}, {1, 0.5, 0, 0});
  EXPECT_EQ(problem(),
            "start: has the box edge 1 beside the diagonal (only the second one may lean, along "
            "x); it may be damaged");
}

TEST_F(StartOutput, WithVelocitiesThatAreNoNumbersIsRejected) {
  write_output({10, 0, 0, 8}, {1, NAN, 0, 0});
  EXPECT_EQ(problem(), "start: has velocities that are not finite numbers; give others");
}

TEST_F(StartOutput, DamagedIsAnInputError) {
  write_output({10, 0, 0, 8}, {1, 0.5, 0, 0});
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  EXPECT_NE(problem().find("cannot be read ("), std::string::npos) << problem();
}

}  // namespace
}  // namespace zenosphere
