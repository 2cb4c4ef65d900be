#include <gtest/gtest.h>

#include <string>

#include "unit/case/case_texts.hpp"

namespace zenosphere {
namespace {

TEST(CaseDrives, KicksNeedStrengthAndIntervalAndNothingElseHasThem) {
  EXPECT_EQ(objection(cooling_case, "drive.kind=random"),
            "e.toml: missing key drive.noise_strength (physics has no default); add noise_strength "
            "= ... under [drive]\n"
            "e.toml: missing key drive.kick_interval (physics has no default); add kick_interval = "
            "... under [drive]");
  EXPECT_EQ(objection(cooling_case, "drive.kick_interval=1"),
            "drive.kick_interval = 1 (only for drive.kind = \"random\"); remove it");
  EXPECT_EQ(objection(cooling_case, "drive.noise_strength=0"),
            "drive.noise_strength = 0 (must be > 0)");
}

TEST(CaseDrives, WallsNeedAnAxisOfTheSystemAndARestitution) {
  EXPECT_EQ(
      problems_of(cooling_case + "[walls]\n"),
      "e.toml: missing key walls.axis (physics has no default); add axis = ... under [walls]");
  EXPECT_EQ(problems_of(triple_case + "[walls]\naxis = \"y\"\n"),
            "e.toml: missing key walls.restitution (physics has no default); add restitution = ... "
            "under [walls]");
  EXPECT_EQ(objection(triple_case + "[walls]\nrestitution = 1\n", "walls.axis=z"),
            "walls.axis = \"z\" (system.dimension = 2 has x and y)");
  EXPECT_EQ(objection(ball_case, "walls.axis=y"),
            "walls.axis = \"y\" (system.dimension = 1 has x only)");
}

TEST(CaseDrives, WallsMoveOnlyAlongThemselves) {
  const std::string walled = triple_case + "[walls]\naxis = \"x\"\nrestitution = 1\n";
  EXPECT_EQ(objection(walled, "walls.upper_speed=1"),
            "walls.upper_speed = 1 (only for walls normal to y or z, which can move along x); "
            "remove it");
  EXPECT_EQ(objection(walled, "walls.tangential_restitution=0"), "");
  EXPECT_EQ(objection(ball_case, "walls.tangential_restitution=0"),
            "walls.tangential_restitution = 0 (only for walls in two or three dimensions); remove "
            "it");
  EXPECT_EQ(objection(walled, "walls.tangential_restitution=-1.5"),
            "walls.tangential_restitution = -1.5 (must be in [-1, 1]; -1 is smooth)");
}

TEST(CaseDrives, FccStaysClearOfWalls) {
  // Spacing 19.112278 / 10, a quarter of it is 0.477807; at phi = 0.2 it is 0.546957.
  const std::string walled = cooling_case + "[walls]\naxis = \"z\"\nrestitution = 1\n";
  EXPECT_EQ(problems_of(walled),
            "e.toml:15:8: walls.axis = \"z\" (the first layer of fcc would be 0.477807 diameters "
            "from the wall, must be at least 0.5); use start.arrangement = \"random\" or a larger "
            "box");
  EXPECT_EQ(objection(walled, "system.solids_volume_fraction=0.2"), "");
}

TEST(CaseDrives, ShearNeedsTwoDimensionsAndNoWalls) {
  EXPECT_EQ(
      problems_of(rod_case, {"drive.kind=shear", "drive.shear_rate=1"}),
      "--set drive.kind=shear: drive.kind = \"shear\" (needs a flow and a gradient direction, "
      "system.dimension = 1); use 2 or 3 dimensions");
  const std::string walled =
      replaced(shear_case, "\"fcc\"", "\"random\"") + "[walls]\naxis = \"y\"\nrestitution = 1\n";
  EXPECT_EQ(
      problems_of(walled),
      "e.toml:11:8: drive.kind = \"shear\" (its gradient direction y ends at walls); shear by "
      "moving walls: walls.lower_speed and walls.upper_speed with drive.kind = \"none\"");
  EXPECT_EQ(problems_of(replaced(walled, "\"y\"", "\"z\"")),
            "e.toml:11:8: drive.kind = \"shear\" (not together with [walls] in this version); "
            "remove one of the two");
}

TEST(CaseDrives, GravityHasTheDimensionOfTheSystem) {
  EXPECT_EQ(objection(cooling_case, "gravity.acceleration=[0, -1]"),
            "gravity.acceleration = [0, -1] (number of components = 2, system.dimension = 3); make "
            "them equal");
  EXPECT_EQ(problems_of(cooling_case + "[gravity]\n"),
            "e.toml: missing key gravity.acceleration (physics has no default); add acceleration = "
            "... under [gravity]");
}

TEST(CaseDrives, GravityUnderShearHasNoComponentAlongTheGradient) {
  const std::string falling =
      replaced(shear_case, "[run]", "[gravity]\nacceleration = [1, 0, 2]\n[run]");
  EXPECT_EQ(problems_of(falling), "");
  EXPECT_EQ(
      objection(falling, "gravity.acceleration=[0, 0.5, 0]"),
      "gravity.acceleration = [0, 0.5, 0] (has a component along y, the gradient direction of "
      "the shear, across whose sliding boundary spheres would fall for ever); let it point "
      "along x or z");
}

TEST(CaseDrives, WhateverDrivesTheSpheresMayStartFromRest) {
  EXPECT_EQ(objection(triple_case, "start.velocities=[[0, 0], [0, 0], [0, 0]]"),
            "start.velocities = [[0, 0], [0, 0], [0, 0]] (nothing would ever move); use a velocity "
            "other than 0, or drive the spheres");
  const std::string rest = "start.granular_temperature=0";
  EXPECT_NE(problems_of(rod_case, {rest}), "");
  EXPECT_EQ(problems_of(rod_case, {rest, "gravity.acceleration=1"}), "");
  EXPECT_NE(problems_of(rod_case, {rest, "gravity.acceleration=0"}), "");
  EXPECT_EQ(problems_of(rod_case, {rest, "drive.kind=random", "drive.noise_strength=1",
                                   "drive.kick_interval=1"}),
            "");
  const std::string walled =
      in_plane(cooling_case) + "[walls]\naxis = \"y\"\nrestitution = 1\nlower_speed = 1\n";
  EXPECT_EQ(problems_of(walled, {rest}), "");
  EXPECT_NE(problems_of(walled, {rest, "walls.lower_speed=0"}), "");
}

}  // namespace
}  // namespace zenosphere
