#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "case/case_box.hpp"
#include "unit/case/case_texts.hpp"

namespace zenosphere {
namespace {

TEST(CaseSystems, EveryNewKeyReachesItsMember) {
  const Case triple = overridden(triple_case, {});
  EXPECT_EQ(triple.system.sides, (std::vector<double>{10, 8}));
  EXPECT_EQ(triple.start.positions, (std::vector<std::vector<double>>{{1, 1}, {2, 1}, {4, 1}}));
  EXPECT_EQ(triple.start.velocities, (std::vector<std::vector<double>>{{1, 0}, {0, 0}, {-1, 0}}));
  EXPECT_FALSE(triple.start.granular_temperature.has_value());
  const Case walled = overridden(
      triple_case, {"walls.axis=y", "walls.restitution=0.5", "walls.tangential_restitution=0.25",
                    "walls.lower_speed=-2", "walls.upper_speed=3", "gravity.acceleration=[1, -2]",
                    "drive.kind=random", "drive.noise_strength=4", "drive.kick_interval=0.125"});
  EXPECT_EQ(walled.walls.axis, Axis::y);
  EXPECT_EQ(walled.walls.restitution, 0.5);
  EXPECT_EQ(walled.walls.tangential_restitution, 0.25);
  EXPECT_EQ(walled.walls.lower_speed, -2);
  EXPECT_EQ(walled.walls.upper_speed, 3);
  EXPECT_EQ(walled.gravity.acceleration, (std::vector<double>{1, -2}));
  EXPECT_EQ(walled.drive.kind, DriveKind::random);
  EXPECT_EQ(walled.drive.noise_strength, 4);
  EXPECT_EQ(walled.drive.kick_interval, 0.125);
}

TEST(CaseSystems, PlainNumbersStandForArraysOfOneInOneDimension) {
  const Case plain = overridden(ball_case, {"gravity.acceleration=-2", "system.sides=5"});
  EXPECT_EQ(plain.start.positions, (std::vector<std::vector<double>>{{1}}));
  EXPECT_EQ(plain.gravity.acceleration, std::vector<double>{-2});
  EXPECT_EQ(plain.system.sides, std::vector<double>{5});
  EXPECT_EQ(overridden(ball_case, {"start.positions=[[1]]"}).start.positions,
            plain.start.positions);
}

TEST(CaseSystems, UnsetTablesStayAbsentAndTheResolvedCaseReadsBack) {
  const std::string cooling = resolved_toml(overridden(cooling_case, {}));
  for (const std::string name : {"[walls]", "[gravity]", "\nsides", "\npositions", "\nfile"}) {
    EXPECT_EQ(cooling.find(name), std::string::npos) << name;
  }
  for (const std::string& text : {triple_case, ball_case, rod_case}) {
    const std::string resolved = resolved_toml(overridden(text, {}));
    EXPECT_EQ(resolved_toml(parse_case(resolved, "resolved", {})), resolved);
  }
  const std::string ball = resolved_toml(overridden(ball_case, {"start.positions=[0.7]"}));
  EXPECT_NE(ball.find("\npositions = [\n  [0.7],\n]  # "), std::string::npos) << ball;
  EXPECT_NE(ball.find("\naxis = \"x\"  # "), std::string::npos) << ball;
  EXPECT_EQ(ball.find("_speed"), std::string::npos) << ball;
}

TEST(CaseSystems, BoxHasTheFractionAndTheProportionAskedFor) {
  // 4 rods fill half of 8; 4000 disks to 0.3 with a = 4: V = 1000 pi / 0.3 = 10471.976,
  // other = sqrt(V / 4) = 51.166336, x = 204.66534.
  EXPECT_EQ(box_sides(overridden(rod_case, {})), std::vector<double>{8});
  const Case disks = overridden(in_plane(cooling_case), {"system.aspect_ratio=4"});
  EXPECT_NEAR(box_sides(disks)[0], 204.66534, 1e-5);
  EXPECT_NEAR(box_sides(disks)[1], 51.166336, 1e-6);
  EXPECT_NEAR(mean_side(disks), 102.33267, 1e-5);  // sqrt(V)
  EXPECT_NEAR(filled_fraction(disks), 0.3, 1e-15);
}

TEST(CaseSystems, BoxHasOneSizeAndAnOverrideReplacesTheOther) {
  const std::string both = replaced(triple_case, "sides", "solids_volume_fraction = 0.1\nsides");
  EXPECT_EQ(problems_of(both),
            "e.toml:6:9: system.sides = [10, 8] (system.solids_volume_fraction is given too); "
            "remove one of them");
  EXPECT_TRUE(overridden(triple_case, {"system.solids_volume_fraction=0.01"}).system.sides.empty());
  const Case sided = overridden(rod_case, {"system.sides=[9]"});
  EXPECT_EQ(sided.system.solids_volume_fraction, 0);
  EXPECT_EQ(box_sides(sided), std::vector<double>{9});
}

TEST(CaseSystems, AspectRatioBelongsToAPlaneOrSpaceWithoutSides) {
  const std::string only =
      "system.aspect_ratio = 2 (only for two or three dimensions, without system.sides); remove it";
  EXPECT_EQ(objection(triple_case, "system.aspect_ratio=2"), only);
  EXPECT_EQ(objection(rod_case, "system.aspect_ratio=2"), only);
  EXPECT_EQ(objection(cooling_case, "system.aspect_ratio=2"),
            "system.aspect_ratio = 2 (fcc fills a cube); remove it or use start.arrangement = "
            "\"random\"");
}

TEST(CaseSystems, SidesFitTheDimensionAndTheSpheres) {
  EXPECT_EQ(objection(triple_case, "system.sides=[10, 8, 6]"),
            "system.sides = [10, 8, 6] (number of sides = 3, system.dimension = 2); make them "
            "equal");
  EXPECT_EQ(objection(triple_case, "system.sides=[10, 2]"),
            "system.sides = [10, 2] (the box side along y is 2 diameters, must be above 2.02)");
  EXPECT_EQ(objection(triple_case, "system.sides=[10, -2]"),
            "system.sides = [10, -2] (-2 in it must be in (1, 1000000000])");
  EXPECT_EQ(objection(triple_case, "system.sides=[10, nan]"),
            "system.sides = [10, nan] (nan in it must be a finite number)");
  EXPECT_EQ(objection(triple_case, "system.sides=[]"),
            "system.sides = [] (found an array, needs an array of numbers)");
  EXPECT_EQ(objection(rod_case, "system.sides=[4.2]"),  // 4 / 4.2 = 0.95238
            "system.sides = [4.2] (4 spheres would fill 0.952381 of the box, at most 0.95 for "
            "start.arrangement = \"random\"); use longer sides");
  EXPECT_EQ(objection(ball_case, "system.sides=[1.5]"), "");
  EXPECT_EQ(
      objection(ball_case, "system.sides=[1.0000000001]"),
      "system.sides = [1.0000000001] (the box side along x is 1.0000000001 diameters, must be "
      "above 1.000000001)");
}

TEST(CaseSystems, FractionHasALimitForEachDimension) {
  const std::string plane = in_plane(cooling_case);
  EXPECT_EQ(objection(plane, "system.solids_volume_fraction=0.6"), "");
  EXPECT_EQ(objection(plane, "system.solids_volume_fraction=0.86"),
            "system.solids_volume_fraction = 0.86 (must be in (0, 0.85] for start.arrangement = "
            "\"random\")");
  EXPECT_EQ(objection(plane, "system.solids_volume_fraction=0.92"),
            "system.solids_volume_fraction = 0.92 (must be in (0, 0.90689]; disks cannot be packed "
            "denser)");
  EXPECT_EQ(objection(rod_case, "system.solids_volume_fraction=0.95"), "");
  EXPECT_EQ(objection(rod_case, "system.solids_volume_fraction=1"),
            "system.solids_volume_fraction = 1 (must be below 1; rods need room)");
}

TEST(CaseSystems, BoxFromAFractionHasTheLongestSideOfOneThatIsGiven) {
  // 2000 spheres of pi/6 in a cube of side 1e9 fill 2000 pi/6 / 1e27 = 1.0472e-24 of it.
  const std::string cube = replaced(cooling_case, "spheres = 4000", "spheres = 2000");
  const std::string random = replaced(cube, "\"fcc\"", "\"random\"");
  EXPECT_EQ(objection(random, "system.solids_volume_fraction=1.048e-24"), "");
  for (const std::string fraction : {"1e-24", "1e-30", "1e-300", "3e-308"}) {
    EXPECT_EQ(objection(random, "system.solids_volume_fraction=" + fraction),
              "system.solids_volume_fraction = " + fraction +
                  " (a side of the box would be above 1000000000 diameters); use at least "
                  "1.05e-24");
  }
  EXPECT_EQ(objection(random, "system.solids_volume_fraction=1.05e-24"), "");
  // 100 x 1 disks: 4000 pi/4 / (1e9 x 1e7) = 3.14e-13; rods: 4 / 1e9.
  const std::string strip = in_plane(cooling_case);
  EXPECT_EQ(
      problems_of(strip, {"system.aspect_ratio=100", "system.solids_volume_fraction=3.15e-13"}),
      "");
  EXPECT_NE(problems_of(strip, {"system.aspect_ratio=100", "system.solids_volume_fraction=3e-13"}),
            "");
  EXPECT_EQ(objection(rod_case, "system.solids_volume_fraction=4e-9"), "");
  EXPECT_NE(objection(rod_case, "system.solids_volume_fraction=3.9e-9"), "");
  const Case longest = overridden(random, {"system.solids_volume_fraction=1.05e-24"});
  EXPECT_LE(box_sides(longest)[0], 1e9);
}

TEST(CaseSystems, RodsNeedRoomHoweverTheBoxIsGiven) {
  const std::string given =
      replaced(replaced(rod_case, "\"random\"", "\"given\"\npositions = [0, 1, 2, 3]"),
               "solids_volume_fraction = 0.5", "sides = [4]");
  EXPECT_EQ(problems_of(given),
            "e.toml:5:9: system.sides = [4] (the rods would fill the box; rods need room); use "
            "longer sides");
}

TEST(CaseSystems, ANumberBesideItsLimitHasTheDigitsThatTellThemApart) {
  EXPECT_EQ(objection(triple_case, "system.sides=[2.02, 2.0199999999]"),
            "system.sides = [2.02, 2.0199999999] (the box side along x is 2.02 diameters, must be "
            "above 2.02)");
  // N = 4 in 4 / 0.9500000001 = 4.2105263153.
  EXPECT_EQ(objection(rod_case, "system.sides=[4.2105263153]"),
            "system.sides = [4.2105263153] (4 spheres would fill 0.9500000001 of the box, at most "
            "0.95 for start.arrangement = \"random\"); use longer sides");
}

TEST(CaseSystems, FccIsThreeDimensional) {
  EXPECT_EQ(objection(cooling_case, "system.dimension=2"),
            "e.toml:8:15: start.arrangement = \"fcc\" (a lattice in 3 dimensions, system.dimension "
            "= 2); use \"random\"");
}

TEST(CaseSystems, OneSphereNeedsWalls) {
  EXPECT_EQ(objection(rod_case, "system.spheres=1"),
            "system.spheres = 1 (must be at least 2 where there are no walls); use 2 or add "
            "[walls]");
  EXPECT_EQ(problems_of(ball_case), "");
}

TEST(CaseSystems, WrittenSpheresHaveTheNumberAndTheDimensionOfTheSystem) {
  EXPECT_EQ(
      objection(triple_case, "system.spheres=4"),
      "e.toml:8:13: start.positions = [[1, 1], [2, 1], [4, 1]] (has 3 spheres, system.spheres "
      "= 4); make them equal\n"
      "e.toml:9:14: start.velocities = [[1, 0], [0, 0], [-1, 0]] (has 3 spheres, "
      "system.spheres = 4); make them equal");
  EXPECT_EQ(objection(triple_case, "start.positions=[[1, 1], 2, [4, 1]]"),
            "start.positions = [[1, 1], 2, [4, 1]] (sphere 1 has 1 components, system.dimension = "
            "2); make them equal");
  EXPECT_EQ(objection(triple_case, "start.positions=[[1, 1], [2, nan], [4, 1]]"),
            "start.positions = [[1, 1], [2, nan], [4, 1]] (sphere 1: found nan, every component "
            "must be a finite number)");
  EXPECT_EQ(objection(triple_case, "start.positions=[[1, 1], \"b\", [4, 1]]"),
            "start.positions = [...] (sphere 1: found text, needs an array of numbers)");
  EXPECT_EQ(objection(triple_case, "start.positions=[[1, 1], [2, [1]], [4, 1]]"),
            "start.positions = [...] (sphere 1: found an array with more than numbers in it, needs "
            "an array of numbers)");
  EXPECT_EQ(objection(triple_case, "start.positions=7"),
            "start.positions = 7 (found an integer, needs an array with an array of numbers for "
            "each sphere)");
}

TEST(CaseSystems, GivenSpheresNeedVelocitiesOrATemperatureNotBoth) {
  const std::string without = replaced(triple_case, "velocities = [[1, 0], [0, 0], [-1, 0]]\n", "");
  EXPECT_EQ(problems_of(without),
            "e.toml: missing key start.granular_temperature or start.velocities (the spheres need "
            "velocities); add one under [start]");
  EXPECT_EQ(problems_of(without, {"start.granular_temperature=1"}), "");
  EXPECT_EQ(
      problems_of(replaced(triple_case, "velocities", "granular_temperature = 1\nvelocities")),
      "e.toml:10:14: start.velocities = [[1, 0], [0, 0], [-1, 0]] "
      "(start.granular_temperature is given too); remove one of them");
  EXPECT_TRUE(overridden(triple_case, {"start.granular_temperature=1"}).start.velocities.empty());
}

TEST(CaseSystems, PositionsBelongToAGivenStartAndFilesToOneFromAFile) {
  EXPECT_EQ(objection(cooling_case, "start.positions=[[1, 2, 3]]"),
            "start.positions = [[1, 2, 3]] (only for start.arrangement = \"given\"); remove it");
  EXPECT_EQ(objection(cooling_case, "start.file=a.xyz"),
            "start.file = \"a.xyz\" (only for start.arrangement = \"file\"); remove it");
  EXPECT_EQ(
      objection(cooling_case, "start.arrangement=file"),
      "e.toml: missing key start.file (physics has no default); add file = ... under [start]");
  const Case idle =
      overridden(triple_case, {"start.arrangement=random", "start.granular_temperature=1"});
  EXPECT_TRUE(idle.start.positions.empty());  // what is not meant cannot be read by mistake
}

TEST(CaseSystems, StartFileIsMeantFromTheDirectoryOfTheCase) {
  const std::vector<std::string> overrides{"start.arrangement=file", "start.file=b/../s.xyz"};
  EXPECT_EQ(parse_case(triple_case, "/a/case.toml", overrides).start.file, "/a/s.xyz");
  const std::vector<std::string> absolute{"start.arrangement=file", "start.file=/s.xyz"};
  EXPECT_EQ(parse_case(triple_case, "/a/case.toml", absolute).start.file, "/s.xyz");
  const auto here = std::filesystem::current_path();
  EXPECT_EQ(parse_case(triple_case, "case.toml", overrides).start.file, (here / "s.xyz").string());
}

TEST(CaseSystems, ABoxIsNotSoLongThatItsCellsAreTooMany) {
  // Cells are 375 x (5 - 1) long where one side has two cells of 5: 1e9/1500 x 2 = 1.3e6 of them.
  EXPECT_EQ(problems_of(triple_case, {"system.sides=[10, 5e8]"}), "");
  EXPECT_EQ(objection(triple_case, "system.sides=[10, 1e9]"),
            "system.sides = [10, 1000000000] (cells that suit the shortest side would be 1.33e+06, "
            "must be at most 1.05e+06); make the sides less unequal");
  EXPECT_EQ(problems_of(triple_case, {"system.sides=[1e6, 1e9]"}), "");
}

}  // namespace
}  // namespace zenosphere
