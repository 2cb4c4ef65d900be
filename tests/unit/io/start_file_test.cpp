#include "io/start_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "io/case_box.hpp"
#include "io/output_file.hpp"
#include "io/start_overlap.hpp"
#include "unit/io/case_texts.hpp"
#include "unit/io/temporary_folder.hpp"

namespace zenosphere {
namespace {

const std::string planar_case = R"([system]
dimension = 2
spheres = 2
restitution = 0.5
sides = [10, 8]
[start]
arrangement = "given"
positions = [[1, 1], [4, 1]]
velocities = [[1, 0.5], [0, 0]]
[drive]
kind = "none"
[run]
collisions = 100
)";

std::string start_problem(const Case& values) {
  try {
    given_start(values);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// What is wrong with two disks in a box of 10 x 8, if anything.
std::string problem_at(const std::string& positions, std::vector<std::string> overrides = {}) {
  overrides.push_back("start.positions=" + positions);
  return start_problem(overridden(planar_case, overrides));
}

TEST(GivenStart, IsWhatTheCaseWrites) {
  const GivenStart start = given_start(overridden(planar_case, {}));
  EXPECT_EQ(start.dimension, 2);
  EXPECT_EQ(start.positions, (std::vector<double>{1, 1, 4, 1}));
  EXPECT_EQ(start.velocities, (std::vector<double>{1, 0.5, 0, 0}));
  EXPECT_EQ(start.sides, (std::vector<double>{10, 8}));
}

TEST(GivenStart, LeavesVelocitiesToBeDrawnWhereATemperatureIsGiven) {
  const Case drawn = overridden(planar_case, {"start.granular_temperature=2"});
  EXPECT_TRUE(given_start(drawn).velocities.empty());
}

TEST(GivenStart, SphereOutsideTheBoxIsNamed) {
  EXPECT_EQ(problem_at("[[1, 1], [4, -0.5]]"),
            "start.positions: sphere 1 at (4, -0.5) is outside the box (0 <= y < 8); move it");
  EXPECT_EQ(problem_at("[[10, 1], [4, 1]]"),
            "start.positions: sphere 0 at (10, 1) is outside the box (0 <= x < 10); move it");
}

TEST(GivenStart, SphereInAWallIsNamedAndMayTouchIt) {
  const std::vector<std::string> walls{"walls.axis=y", "walls.restitution=1"};
  EXPECT_EQ(problem_at("[[1, 0.5], [4, 7.5]]", walls), "");
  EXPECT_EQ(problem_at("[[1, 0.499], [4, 1]]", walls),
            "start.positions: sphere 0 at (1, 0.499) is in a wall (0.5 <= y <= 7.5); move it");
  EXPECT_EQ(problem_at("[[1, 1], [4, 7.6]]", walls),
            "start.positions: sphere 1 at (4, 7.6) is in a wall (0.5 <= y <= 7.5); move it");
}

TEST(GivenStart, OverlappingSpheresAreNamedAndTouchingOnesPass) {
  EXPECT_EQ(problem_at("[[1, 1], [1.93, 1]]"),
            "start.positions: spheres 0 and 1 overlap (distance 0.93 diameters); move them apart");
  EXPECT_EQ(problem_at("[[1, 1], [2, 1]]"), "");
  EXPECT_EQ(problem_at("[[1, 1], [1.9999999999995, 1]]"), "");  // 5e-13 is rounding, 5e-12 is not
  EXPECT_NE(problem_at("[[1, 1], [1.999999999995, 1]]"), "");
}

TEST(GivenStart, SpheresOverlapAcrossPeriodicFacesAndNotAcrossWalls) {
  EXPECT_EQ(problem_at("[[9.75, 7.75], [0.25, 0.25]]"),  // 0.5 sqrt(2)
            "start.positions: spheres 0 and 1 overlap (distance 0.7071067811865 diameters); move "
            "them apart");
  const std::vector<std::string> walls{"walls.axis=x", "walls.restitution=1",
                                       "system.sides=[2, 8]"};
  EXPECT_EQ(problem_at("[[0.5, 1], [1.5, 1]]", walls), "");
}

TEST(FirstOverlap, AgreesWithLookingAtEveryPair) {
  // 60 spheres at multiples of an irrational number, in boxes of one, two and many cells a side.
  for (const std::vector<double>& sides :
       {std::vector<double>{2.5, 30, 1.2}, {3.5, 4, 9}, {60, 7}, {150}}) {
    std::vector<double> positions;
    for (std::size_t n = 1; n <= 60 * sides.size(); ++n) {
      const double part = std::fmod(static_cast<double>(n * n) * 0.6180339887498949, 1.0);
      positions.push_back(part * sides[(n - 1) % sides.size()]);
    }
    const int closed = static_cast<int>(sides.size()) - 1;
    std::string expected;
    for (std::size_t i = 0; i < 60 && expected.empty(); ++i) {
      for (std::size_t j = i + 1; j < 60 && expected.empty(); ++j) {
        double square = 0;
        for (std::size_t axis = 0; axis < sides.size(); ++axis) {
          double along =
              std::abs(positions[i * sides.size() + axis] - positions[j * sides.size() + axis]);
          if (static_cast<int>(axis) != closed) along = std::min(along, sides[axis] - along);
          square += along * along;
        }
        if (square < 1) expected = fmt::format("{} {}", i, j);
      }
    }
    const auto found = first_overlap(positions, sides, closed);
    ASSERT_TRUE(found) << sides.size();
    EXPECT_EQ(fmt::format("{} {}", found->i, found->j), expected) << sides.size();
  }
}

TEST(FirstOverlap, ManyTouchingSpheresPassAndOneDisplacedAmongThemIsFound) {
  // A simple cubic lattice of 20^3 touching spheres; number 4210 is at (10, 10, 10).
  std::vector<double> positions;
  for (int n = 0; n < 8000; ++n) {
    for (const int component : {n / 400, n / 20 % 20, n % 20}) positions.push_back(component);
  }
  EXPECT_FALSE(first_overlap(positions, {20, 20, 20}, std::nullopt));
  positions[3 * 4210] += 0.25;
  const auto found = first_overlap(positions, {20, 20, 20}, std::nullopt);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->i, 4210);
  EXPECT_EQ(found->j, 4610);  // the neighbour at (11, 10, 10)
  EXPECT_EQ(found->distance, 0.75);
}

class StartFile : public testing::Test {
 protected:
  /// The planar case with its start in a file.
  Case case_with(std::vector<std::string> overrides = {}) const {
    overrides.insert(overrides.end(), {"start.arrangement=file", "start.file=" + file.string()});
    return overridden(planar_case, overrides);
  }
  void write(const std::string& content) const { std::ofstream(file, std::ios::binary) << content; }
  /// The problem of the content, without the folder.
  std::string problem_of(const std::string& content) const {
    write(content);
    return problem();
  }
  std::string problem(const std::vector<std::string>& overrides = {}) const {
    const std::string text = start_problem(case_with(overrides));
    const std::string place = folder.path.string() + "/";
    return text.starts_with(place) ? text.substr(place.size()) : text;
  }
  void write_output(const std::vector<double>& edges, const std::vector<double>& velocities) const {
    OutputFile output(file, {"case", "resolved", 2, 2}, OutputFile::Existing::replace);
    output.write({0, 0, {2, 2, 6, 6}, {9, 9, 9, 9}, {10, 0, 0, 8}});
    output.write({4, 0.5, {1, 1, 4, 1}, velocities, edges});
    output.begin({});
  }

  TemporaryFolder folder;
  std::filesystem::path file = folder.path / "start";
};

const std::string header =
    "2\nLattice=\"10 0 0 0 8 0 0 0 1\" Properties=species:S:1:pos:R:3:velo:R:3\n";
const std::string rows = "A 1 1 0 1 0.5 0\nA 4 1 0 0 0 0\n";

TEST_F(StartFile, ExtendedXyzGivesItsLastFrame) {
  write("3\nany comment\nA 0 0 0\nB 1 1 1\nC 2 2 2\n" + header + rows + "\n");
  const GivenStart start = given_start(case_with());
  EXPECT_EQ(start.positions, (std::vector<double>{1, 1, 4, 1}));
  EXPECT_EQ(start.velocities, (std::vector<double>{1, 0.5, 0, 0}));
  EXPECT_EQ(start.sides, (std::vector<double>{10, 8}));
}

TEST_F(StartFile, ExtendedXyzMayHaveOtherColumnsLineEndsAndNoLattice) {
  write(
      "2\r\nproperties=id:I:1:velocity:R:3:Name:S:2:POS:R:3 time=\"0 1\"\r\n"
      "7 1 5e-1 0 a b +1 1.0 0 \r\n8\t0 0 0 a b 4 1 0\r\n");
  const GivenStart start = given_start(case_with());
  EXPECT_EQ(start.positions, (std::vector<double>{1, 1, 4, 1}));
  EXPECT_EQ(start.velocities, (std::vector<double>{1, 0.5, 0, 0}));
}

TEST_F(StartFile, WithoutVelocitiesNeedsATemperature) {
  EXPECT_EQ(problem_of("2\n\nA 1 1 0\nA 4 1 0\n"),
            "start: has no velocities (a column velo:R:3); add them or start.granular_temperature");
  EXPECT_EQ(problem({"start.granular_temperature=1"}), "");
}

TEST_F(StartFile, ThatIsNoExtendedXyzIsRejectedWithItsLine) {
  EXPECT_EQ(problem_of(""), "start: is empty (needs a frame of extended XYZ)");
  EXPECT_EQ(problem_of("\n\n"), "start: is empty (needs a frame of extended XYZ)");
  EXPECT_EQ(problem_of("two\n"),
            "start:1: found no number of spheres (extended XYZ begins each frame with it)");
  EXPECT_EQ(problem_of("999999999999\n"),
            "start:1: 999999999999 spheres (must be in [1, 16777215])");
  EXPECT_EQ(problem_of("3\n\nA 1 1 0\n"),
            "start:4: the file ends (the frame that begins in line 1 needs 5 lines)");
  EXPECT_EQ(problem_of("3\n\nA 1 1 0\nA 2 2 0\nA 3 3 0\n"),
            "start:1: has 3 spheres (system.spheres = 2); make them equal");
  EXPECT_EQ(problem_of(header + "A 1 1 0 1 0.5 0\nA 4 1 0 0 0\n"), "start:4: has too few numbers");
  EXPECT_EQ(problem_of(header + "A 1 x 0 1 0.5 0\n" + rows.substr(16)),
            "start:3: found \"x\", needs a finite number");
  EXPECT_EQ(problem_of(header + "A 1 nan 0 1 0.5 0\n" + rows.substr(16)),
            "start:3: found \"nan\", needs a finite number");
  EXPECT_EQ(problem_of(header + "A 1 1 2 1 0.5 0\n" + rows.substr(16)),
            "start:3: column 4 is 2 (must be 0 where system.dimension = 2)");
  EXPECT_EQ(problem_of("2\nProperties=species:S:1:force:R:3\n" + rows),
            "start:2: Properties has no pos:R:3; add the positions");
  EXPECT_EQ(problem_of("2\nProperties=pos:R:-3\n" + rows),
            "start:2: Properties: column \"pos\" has the count \"-3\" (must be in [1, 10000])");
  EXPECT_EQ(problem_of(std::string(1'048'577, '1')),
            "start:1: line of more than 1 MiB (is this a text file?)");
}

TEST_F(StartFile, HasTheBoxOfTheCase) {
  EXPECT_EQ(problem_of(replaced(header, "10", "10.1") + rows),
            "start: has a box of 10.1 x 8 diameters (that of the case is 10 x 8); make them equal "
            "with system.sides");
  EXPECT_EQ(problem_of(replaced(header, "10 0 0", "10 3 0") + rows),
            "start:2: Lattice has 3 beside its diagonal (the box must be upright)");
  EXPECT_EQ(problem_of(replaced(header, " 0 1\"", "\"") + rows), "start:2: has too few numbers");
  EXPECT_EQ(problem_of(replaced(header, "10", "10.000000001") + rows), "");
}

TEST_F(StartFile, WithSpheresThatOverlapNamesThem) {
  EXPECT_EQ(problem_of(header + "A 1 1 0 1 0 0\nA 1.5 1 0 0 0 0\n"),
            "start: spheres 0 and 1 overlap (distance 0.5 diameters); move them apart");
}

TEST_F(StartFile, InWhichNothingMovesNeedsADrive) {
  EXPECT_EQ(problem_of(header + "A 1 1 0 0 0 0\nA 4 1 0 0 0 0\n"),
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

TEST_F(StartFile, OutputFileGivesItsLastSnapshot) {
  write_output({10, 0, 1e-13, 8}, {1, 0.5, 0, 0});
  const GivenStart start = given_start(case_with());
  EXPECT_EQ(start.positions, (std::vector<double>{1, 1, 4, 1}));
  EXPECT_EQ(start.velocities, (std::vector<double>{1, 0.5, 0, 0}));
  EXPECT_EQ(start.sides, (std::vector<double>{10, 8}));
}

TEST_F(StartFile, OutputFileOfAnotherSystemIsRejected) {
  write_output({10, 0, 0, 8}, {1, 0.5, 0, 0});
  EXPECT_EQ(problem({"system.spheres=3"}),
            "start: has 2 spheres (system.spheres = 3); make them equal");
  EXPECT_EQ(problem({"system.dimension=3", "system.sides=[10, 8, 8]"}),
            "start: has 2 dimensions (system.dimension = 3); make them equal");
  EXPECT_EQ(problem({"system.sides=[8, 8]"}),
            "start: has a box of 10 x 8 diameters (that of the case is 8 x 8); make them equal "
            "with system.sides");
}

TEST_F(StartFile, OutputFileWithASlidBoxIsRejected) {
  write_output({10, 0, 2.5, 8}, {1, 0.5, 0, 0});
  EXPECT_EQ(problem(),
            "start: its box is sheared by an offset of 2.5 diameters (a run starts from an upright "
            "box, whose images lie elsewhere); take the end of a run whose strain x height is a "
            "whole number of lengths");
}

TEST_F(StartFile, OutputFileWithVelocitiesThatAreNoNumbersIsRejected) {
  write_output({10, 0, 0, 8}, {1, NAN, 0, 0});
  EXPECT_EQ(problem(), "start: has velocities that are not finite numbers; give others");
}

TEST_F(StartFile, DamagedOutputFileIsAnInputError) {
  write_output({10, 0, 0, 8}, {1, 0.5, 0, 0});
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  EXPECT_NE(problem().find("cannot be read ("), std::string::npos) << problem();
}

}  // namespace
}  // namespace zenosphere
