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

TEST(GivenStart, SphereBeyondAPeriodicFaceIsItsImageInTheBox) {
  const auto places = [](const std::string& positions) {
    return given_start(overridden(planar_case, {"start.positions=" + positions})).positions;
  };
  EXPECT_EQ(places("[[10, 1], [4, -0.5]]"), (std::vector<double>{0, 1, 4, 7.5}));
  EXPECT_EQ(places("[[-25, 1], [4, 24.5]]"), (std::vector<double>{5, 1, 4, 0.5}));
  // 1e-20 below the lower face is the face itself: 10 - 1e-20 rounds to 10, which is 0.
  EXPECT_EQ(places("[[-1e-20, 1], [4, 1]]"), (std::vector<double>{0, 1, 4, 1}));
  EXPECT_EQ(problem_at("[[10.5, 1], [1, 1]]"),
            "start.positions: spheres 0 and 1 overlap (distance 0.5 diameters); move them apart");
  EXPECT_EQ(problem_at("[[1, 1], [4, 1e300]]"),
            "start.positions: sphere 1 at (4, 1e+300) is too far away to be wrapped into the box "
            "(|y| <= 1000000000); move it");
}

TEST(GivenStart, ImageAcrossTheGradientFaceHasTheProfileOfItsPlace) {
  // Two boxes of height 8 up, at the rate 0.25, the profile is faster by 4.
  const Case sheared = overridden(planar_case, {"drive.kind=shear", "drive.shear_rate=0.25",
                                                "start.positions=[[1, 17], [4, 1]]"});
  const GivenStart start = given_start(sheared);
  EXPECT_EQ(start.positions, (std::vector<double>{1, 1, 4, 1}));
  EXPECT_EQ(start.velocities, (std::vector<double>{-3, 0.5, 0, 0}));
}

TEST(GivenStart, SphereInAWallIsNamedAndMayTouchIt) {
  const std::vector<std::string> walls{"walls.axis=y", "walls.restitution=1"};
  EXPECT_EQ(problem_at("[[1, 0.5], [4, 7.5]]", walls), "");
  EXPECT_EQ(problem_at("[[1, 0.499], [4, 1]]", walls),
            "start.positions: sphere 0 at (1, 0.499) is in a wall (0.5 <= y <= 7.5); move it");
  EXPECT_EQ(problem_at("[[1, 1], [4, 7.6]]", walls),
            "start.positions: sphere 1 at (4, 7.6) is in a wall (0.5 <= y <= 7.5); move it");
}

TEST(GivenStart, SphereBehindAWallIsNotWrapped) {
  const std::vector<std::string> walls{"walls.axis=y", "walls.restitution=1"};
  EXPECT_EQ(problem_at("[[11, 1], [4, 1]]", walls), "");
  EXPECT_EQ(problem_at("[[1, 1], [4, 8.5]]", walls),
            "start.positions: sphere 1 at (4, 8.5) is behind a wall (0.5 <= y <= 7.5); move it");
}

TEST(GivenStart, SphereThatRestsOnAWallUnderGravityIsNamed) {
  const std::vector<std::string> floor{"walls.axis=y", "walls.restitution=0.5",
                                       "gravity.acceleration=[0, -1]",
                                       "collision.contact_duration=1e-3"};
  const auto with = [&](const std::string& velocities) {
    auto overrides = floor;
    overrides.push_back("start.velocities=" + velocities);
    return overrides;
  };
  // The second one stands on the first: that touches the floor.
  EXPECT_EQ(
      problem_at("[[1, 0.5], [1, 1.5]]", with("[[0, 0], [0, 0]]")),
      "start.positions: sphere 0 at (1, 0.5) rests on a wall, where gravity holds it (contacts "
      "of hard spheres are instants: the clock would stand at 0); lift it, or give it a speed "
      "away from the wall");
  EXPECT_EQ(problem_at("[[1, 0.5], [1, 1.5]]", with("[[0, 0.25], [0, 0]]")), "");
  EXPECT_EQ(problem_at("[[1, 0.75], [1, 1.75]]", with("[[0, 0], [0, 0]]")), "");
  EXPECT_EQ(problem_at("[[1, 7.5], [1, 2]]", with("[[0, 0], [0, 0]]")), "");  // falls
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

TEST_F(StartFile, ExtendedXyzMayHaveOtherColumnsLineEndsAndBrackets) {
  write(
      "2\r\nproperties=id:I:1:velocity:R:3:Name:S:2:POS:R:3 time=\"0 \\\" Lattice=\" LATTICE = "
      "[[10, 0, 0], [0, 8, 0], [0, 0, 1]]\r\n"
      "7 1 5e-1 0 a b +1 1.0 0 \r\n8\t0 0 0 a b 4 1 0\r\n");
  const GivenStart start = given_start(case_with());
  EXPECT_EQ(start.positions, (std::vector<double>{1, 1, 4, 1}));
  EXPECT_EQ(start.velocities, (std::vector<double>{1, 0.5, 0, 0}));
}

TEST_F(StartFile, WithoutVelocitiesNeedsATemperature) {
  EXPECT_EQ(problem_of("2\nLattice=\"10 0 0 0 8 0 0 0 1\"\nA 1 1 0\nA 4 1 0\n"),
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
            "start:3: found \"x\", needs a finite number that a double can hold");
  EXPECT_EQ(problem_of(header + "A 1 nan 0 1 0.5 0\n" + rows.substr(16)),
            "start:3: found \"nan\", needs a finite number that a double can hold");
  EXPECT_EQ(problem_of(header + "A 1 1 2 1 0.5 0\n" + rows.substr(16)),
            "start:3: column 4 is 2 (must be 0 where system.dimension = 2)");
  EXPECT_EQ(problem_of(header + "A 1 1e-400 0 1 0.5 0\n" + rows.substr(16)),
            "start:3: found \"1e-400\", needs a finite number that a double can hold");
  EXPECT_EQ(problem_of(header + "A 1 1 0 1 0.5 0 7\n" + rows.substr(16)),
            "start:3: has 8 columns (Properties has 7); make them equal");
  const std::string lattice = "2\nLattice=\"10 0 0 0 8 0 0 0 1\" ";
  EXPECT_EQ(problem_of(lattice + "Properties=species:S:1:force:R:3\n" + rows),
            "start:2: Properties has no pos:R:3; add the positions");
  EXPECT_EQ(problem_of(lattice + "Properties=pos:R:-3\n" + rows),
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
  const std::string three =
      "start:2: Lattice has 3 numbers (must be 9, three vectors); write \"Lx 0 0 "
      "0 Ly 0 0 0 Lz\"";
  EXPECT_EQ(problem_of(replaced(header, "10 0 0 0 8 0 0 0 1", "5 6 7") + rows), three);
  EXPECT_EQ(problem_of(replaced(header, "10 0 0 0 8 0 0 0 1", "10 0 0 0 8 0 0 0 1 0") + rows),
            replaced(three, "3 numbers", "10 numbers"));
  EXPECT_EQ(
      problem_of("2\nany comment\nA 1 1 0\nA 4 1 0\n"),
      "start:2: has no Lattice (which box are the spheres in?); add Lattice=\"Lx 0 0 0 Ly 0 0 "
      "0 Lz\"");
  EXPECT_EQ(problem_of(replaced(header, "10", "10.000000001") + rows), "");
}

/// The header with more in front of its Properties.
std::string header_with(const std::string& more) {
  return replaced(header, " Properties", " " + more + " Properties");
}

TEST_F(StartFile, OriginIsTheLowestCornerOfTheBox) {
  write(header_with("Origin=\"-5 -4 -0.5\"") + "A -4 -3 0 1 0.5 0\nA -1 -3 0 0 0 0\n");
  EXPECT_EQ(given_start(case_with()).positions, (std::vector<double>{1, 1, 4, 1}));
  EXPECT_EQ(problem_of(header_with("Origin=\"0 0\"") + rows),
            "start:2: Origin has 2 numbers (must be 3)");
}

TEST_F(StartFile, BoundariesAreThoseOfTheCase) {
  const std::vector<std::string> walls{"walls.axis=y", "walls.restitution=1"};
  EXPECT_EQ(problem_of(header_with("pbc=\"T T F\"") + rows), "");  // there is no z
  EXPECT_EQ(problem(walls),
            "start: pbc has T along y (the case has [walls] there); make them agree");
  EXPECT_EQ(problem_of(header_with("pbc=[true, False, TRUE]") + rows),
            "start: pbc has F along y (the case is periodic there); make them agree");
  EXPECT_EQ(problem(walls), "");
  EXPECT_EQ(problem_of(header_with("pbc=\"F F F\"") + rows),
            "start: pbc has F along x (the case is periodic there); make them agree");
  EXPECT_EQ(problem_of(header_with("pbc=\"T\"") + rows), "start:2: pbc has 1 words (must be 3)");
  EXPECT_EQ(problem_of(header_with("pbc=\"T T no\"") + rows),
            "start:2: pbc has \"no\" (must be T or F)");
}

TEST_F(StartFile, WhatIsToldTwiceIsRefused) {
  EXPECT_EQ(problem_of(header_with("lattice=\"9 0 0 0 8 0 0 0 1\"") + rows),
            "start:2: has lattice twice; keep one");
  const std::string both = replaced(header, "velo:R:3", "velo:R:3:vel:R:3");
  EXPECT_EQ(problem_of(both + "A 1 1 0 1 0.5 0 2 0 0\nA 4 1 0 0 0 0 0 0 0\n"),
            "start:2: Properties has velo and vel (which are the velocities?); keep one");
  EXPECT_EQ(problem_of(replaced(header, "velo", "pos") + rows),
            "start:2: Properties has pos twice; keep one");
}

TEST_F(StartFile, MomentaBesideVelocitiesMustRepeatThem) {
  const std::string both = replaced(header, "velo:R:3", "velo:R:3:momenta:R:3");
  EXPECT_EQ(problem_of(both + "A 1 1 0 1 0.5 0 1 0.5 0\nA 4 1 0 0 0 0 0 0 0\n"), "");
  EXPECT_EQ(given_start(case_with()).velocities, (std::vector<double>{1, 0.5, 0, 0}));
  EXPECT_EQ(problem_of(both + "A 1 1 0 1 0.5 0 2 1 0\nA 4 1 0 0 0 0 0 0 0\n"),
            "start:3: momentum 2 beside velo 1 (they are equal: mass is the unit); keep one");
  EXPECT_EQ(problem_of(replaced(both, "momenta:R:3", "momenta:R:2") +
                       "A 1 1 0 1 0.5 0 1 0.5\nA 4 1 0 0 0 0 0 0\n"),
            "start:2: Properties has momenta of 2 columns (must be 3, as of velo)");
}

TEST_F(StartFile, RadiusDiameterAndMassAreThoseOfAUnitSphere) {
  const auto with = [](const std::string& name, const std::string& value) {
    return replaced(header, "velo:R:3", "velo:R:3:" + name + ":R:1") + "A 1 1 0 1 0.5 0 " + value +
           "\nA 4 1 0 0 0 0 " + value + "\n";
  };
  EXPECT_EQ(problem_of(with("radius", "0.5")), "");
  EXPECT_EQ(problem_of(with("masses", "1.0")), "");
  EXPECT_EQ(problem_of(with("radius", "1")),
            "start:3: radius = 1 (spheres have 0.5: diameter and mass are the units); give the "
            "file in them");
  EXPECT_EQ(problem_of(with("Diameter", "2")),
            "start:3: diameter = 2 (spheres have 1: diameter and mass are the units); give the "
            "file in them");
  EXPECT_EQ(problem_of(with("mass", "1.008")),
            "start:3: mass = 1.008 (spheres have 1: diameter and mass are the units); give the "
            "file in them");
}

TEST_F(StartFile, MomentaAreVelocitiesWhereTheMassIsKnownToBeOne) {
  const std::string momenta = replaced(header, "velo", "momenta");
  write(momenta + "X 1 1 0 1 0.5 0\nX 4 1 0 0 0 0\n");  // ASE: the element X has the mass 1
  EXPECT_EQ(given_start(case_with()).velocities, (std::vector<double>{1, 0.5, 0, 0}));
  write(replaced(momenta, "momenta:R:3", "momenta:R:3:masses:R:1") +
        "H 1 1 0 1 0.5 0 1\nH 4 1 0 0 0 0 1\n");
  EXPECT_EQ(given_start(case_with()).velocities, (std::vector<double>{1, 0.5, 0, 0}));
  EXPECT_EQ(problem_of(momenta + "H 1 1 0 1 0.5 0\nH 4 1 0 0 0 0\n"),
            "start: has momenta of spheres whose mass it does not tell (must be 1); add a column "
            "masses:R:1, or give velo:R:3");
  EXPECT_EQ(problem({"start.granular_temperature=1"}), "");  // they are drawn anew
}

TEST_F(StartFile, WithSpeedsBeyondTheRangeOfTheirProductsIsRefused) {
  EXPECT_EQ(problem_of(header + "A 1 1 0 0 0 0\nA 4 1 0 0 -1e155 0\n"),
            "start: the fastest sphere, 1, has a velocity of -1e+155; must be 0 or in [1e-100, "
            "1e+100]; choose another unit of time");
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
