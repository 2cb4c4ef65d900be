#include "case/case_speeds.hpp"

#include <gtest/gtest.h>

#include "unit/case/case_texts.hpp"

namespace zenosphere {
namespace {

const std::string range = "must be 0 or in [1e-75, 1e+75]); choose another unit of time";

TEST(CaseSpeeds, TemperatureLiesWhereProductsOfThreeSpeedsAreNumbers) {
  for (const std::string right : {"1e-150", "1e-100", "1e90", "1e150"}) {
    EXPECT_EQ(objection(cooling_case, "start.granular_temperature=" + right), "") << right;
  }
  for (const std::string wrong : {"1e-151", "1e-300", "1.001e+150", "1e+306"}) {
    EXPECT_EQ(objection(cooling_case, "start.granular_temperature=" + wrong),
              "start.granular_temperature = " + wrong +
                  " (must be 0 or in [1e-150, 1e+150]); choose another unit of time");
  }
}

TEST(CaseSpeeds, WrittenVelocitiesAreJudgedByTheFastest) {
  EXPECT_EQ(objection(triple_case, "start.velocities=[[1e75, 0], [1e-300, 0], [0, 0]]"), "");
  EXPECT_EQ(objection(triple_case, "start.velocities=[[0, 0], [0, -1e155], [1, 0]]"),
            "start.velocities = [[0, 0], [0, -1e+155], [1, 0]] (the fastest sphere, 1, has a "
            "velocity of -1e+155; " +
                range);
  EXPECT_EQ(objection(triple_case, "start.velocities=[[1e-76, 0], [0, 0], [0, 0]]"),
            "start.velocities = [[1e-76, 0], [0, 0], [0, 0]] (the fastest sphere, 0, has a "
            "velocity of 1e-76; " +
                range);
}

/// 108 spheres at phi = 0.3: a side of (108 pi/6 / 0.3)^(1/3) = 5.734.
const std::string small = replaced(shear_case, "4000", "108");

TEST(CaseSpeeds, ShearLeavesTheDigitsOfTheTemperature) {
  // 0.01 / 2^-52 / 5.734 = 7.854e12 at T = 1; 2^11 times as much in extended.
  const std::string warm = replaced(small, "6e-3", "1");
  EXPECT_EQ(objection(warm, "drive.shear_rate=7.8e12"), "");
  EXPECT_EQ(objection(warm, "drive.shear_rate=1e+13"),
            "drive.shear_rate = 10000000000000.0 (the speed across the box is rounded to 0.013 in "
            "double, the thermal speed is 1); use at most 7.81e+12, a hotter "
            "start or more digits in collision.precision");
  EXPECT_EQ(problems_of(warm, {"drive.shear_rate=1e13", "collision.precision=extended"}), "");
  EXPECT_EQ(problems_of(warm, {"drive.shear_rate=1e13", "start.granular_temperature=1e26"}), "");
  EXPECT_EQ(problems_of(warm, {"drive.shear_rate=1e13", "start.granular_temperature=0"}), "");
  EXPECT_NE(problems_of(warm, {"drive.shear_rate=1e17", "collision.precision=extended"}), "");
  EXPECT_EQ(problems_of(warm, {"drive.shear_rate=1e17", "collision.precision=quad"}), "");
}

TEST(CaseSpeeds, ShearAndGravityAndWallsHaveTheRangeOfAllSpeeds) {
  EXPECT_NE(objection(small, "drive.shear_rate=1e-77").find("the speed across the box is 5.73"),
            std::string::npos);
  EXPECT_EQ(objection(small, "drive.shear_rate=1e-74"), "");
  EXPECT_EQ(objection(ball_case, "gravity.acceleration=[-1e148]"), "");
  // sqrt(2 x 10 x 1e170)
  EXPECT_EQ(objection(ball_case, "gravity.acceleration=[-1e170]"),
            "gravity.acceleration = [-1e+170] (the speed after a fall through the box is 4.47e+85 "
            "diameters/time, " +
                range);
  const std::string walled =
      replaced(triple_case, "[run]", "[walls]\naxis = \"y\"\nrestitution = 1\n[run]");
  EXPECT_EQ(objection(walled, "walls.upper_speed=-1e75"), "");
  EXPECT_NE(objection(walled, "walls.upper_speed=-1e76"), "");
  EXPECT_NE(objection(walled, "walls.lower_speed=1e-80"), "");
}

TEST(CaseSpeeds, ARoughWallIsSlowEnoughForThePlacesOfWhatItMoves) {
  // 8 / 1 until the wall is reached: 8 v 2^-52 = 1e-6 at v = 5.6e8.
  const std::string walled = replaced(
      replaced(triple_case, "[run]",
               "[walls]\naxis = \"y\"\nrestitution = 1\ntangential_restitution = 0\n[run]"),
      "velocities = [[1, 0], [0, 0], [-1, 0]]", "granular_temperature = 1");
  EXPECT_EQ(objection(walled, "walls.upper_speed=5.6e8"), "");
  EXPECT_NE(objection(walled, "walls.upper_speed=5.7e8"), "");
  EXPECT_EQ(problems_of(walled, {"walls.upper_speed=5.7e8", "collision.precision=extended"}), "");
  EXPECT_EQ(problems_of(walled, {"walls.upper_speed=1e16", "walls.tangential_restitution=-1"}), "");
}

const std::string kicked =
    replaced(cooling_case, "\"none\"", "\"random\"\nnoise_strength = 1\nkick_interval = 1");

TEST(CaseSpeeds, KicksHaveTheRangeOfSpeedsAndOfPlaces) {
  EXPECT_EQ(problems_of(kicked), "");
  EXPECT_NE(objection(kicked, "drive.noise_strength=1e-151"), "");
  EXPECT_EQ(objection(kicked, "drive.noise_strength=1e-149"), "");
  // sqrt(noise) x interval^1.5 x 2^-52 = 1e-6 at a noise of 2e19.
  EXPECT_EQ(objection(kicked, "drive.noise_strength=2e19"), "");
  EXPECT_EQ(objection(kicked, "drive.noise_strength=3e19"),
            "drive.noise_strength = 3e+19 (a sphere flies 5.48e+09 diameters between kicks, which "
            "is rounded to 1.2e-06 in double, must be at most 1e-06); kick more often or use more "
            "digits in collision.precision");
  EXPECT_EQ(problems_of(kicked, {"drive.noise_strength=3e19", "collision.precision=quad"}), "");
}

TEST(CaseSpeeds, KicksAndSnapshotsAreAsManyAsCollisionsAtMost) {
  EXPECT_EQ(problems_of(kicked, {"run.time=1e15"}), "");
  EXPECT_EQ(problems_of(kicked, {"run.time=1.1e15"}),
            "e.toml:13:17: drive.kick_interval = 1 (more than 1e+15 until run.time = "
            "1100000000000000); use a longer one");
  EXPECT_EQ(problems_of(cooling_case, {"run.time=1", "output.snapshot_interval=1e-15"}), "");
  EXPECT_NE(problems_of(cooling_case, {"run.time=1", "output.snapshot_interval=1e-300"}), "");
}

TEST(CaseSpeeds, AFreeFallLeavesTheDigitsOfTheTemperature) {
  // 0.01 / 2^-52 = 4.5e13 at T = 1.
  const std::string falling =
      replaced(cooling_case, "[run]", "[gravity]\nacceleration = [0, 0, 1]\n[run]");
  EXPECT_EQ(problems_of(falling, {"run.time=4.5e13"}), "");
  EXPECT_NE(problems_of(falling, {"run.time=4.6e13"}), "");
  EXPECT_EQ(problems_of(falling, {"run.time=4.6e13", "collision.precision=quad"}), "");
}

TEST(CaseSpeeds, AFreeFallEndsAtASpeedThatIsOne) {
  const std::string falling =
      replaced(cooling_case, "[run]", "[gravity]\nacceleration = [0, 0, 1e10]\n[run]");
  const std::vector<std::string> cold{"start.granular_temperature=0", "run.time=1e65"};
  EXPECT_EQ(problems_of(falling, cold), "");
  EXPECT_NE(problems_of(falling, {cold[0], "run.time=1.1e65"})
                .find("(the speed of the fall at run.time is 1.1e+75 diameters/time, "),
            std::string::npos);
}

// The three of the triple have velocities 1, 0, -1 along x: sqrt(2/3/2) = 0.577 in a plane.
TEST(CaseSpeeds, GivenVelocitiesAreATemperatureToo) {
  const std::string falling =
      replaced(triple_case, "[run]", "[gravity]\nacceleration = [1, 0]\n[run]");
  EXPECT_EQ(problems_of(falling, {"run.time=2.5e13"}), "");  // 0.01 x 0.577 / 2^-52 = 2.6e13
  EXPECT_NE(problems_of(falling, {"run.time=2.7e13"}).find("the thermal speed is 0.577"),
            std::string::npos);
  const std::string sheared = replaced(triple_case, "\"none\"", "\"shear\"\nshear_rate = 1");
  EXPECT_EQ(objection(sheared, "drive.shear_rate=3e12"), "");  // 8 x 3e12 below 2.6e13
  EXPECT_NE(objection(sheared, "drive.shear_rate=4e12"), "");
  const std::string rough =
      replaced(triple_case, "[run]",
               "[walls]\naxis = \"y\"\nrestitution = 1\ntangential_restitution = 0\n[run]");
  EXPECT_EQ(objection(rough, "walls.upper_speed=3e8"), "");  // 8 / 0.577 v 2^-52 = 1e-6: 3.2e8
  EXPECT_NE(objection(rough, "walls.upper_speed=3.3e8"), "");
}

TEST(CaseSpeeds, WhatAllGivenSpheresShareIsNoTemperature) {
  const std::string drifting =
      replaced(triple_case, "[[1, 0], [0, 0], [-1, 0]]", "[[0.1, 0.3], [0.1, 0.3], [0.1, 0.3]]");
  const std::string falling =
      replaced(drifting, "[run]", "[gravity]\nacceleration = [1, 0]\n[run]");
  EXPECT_EQ(problems_of(falling, {"run.time=1e70"}), "");
  // At rest in the flow, of which the middle, at 4, rests: at the height 1 it flows at -3e16.
  const std::string flowing = replaced(
      replaced(triple_case, "[[1, 0], [0, 0], [-1, 0]]", "[[-3e16, 0], [-3e16, 0], [-3e16, 0]]"),
      "\"none\"", "\"shear\"\nshear_rate = 1e16");
  EXPECT_EQ(problems_of(flowing), "");
}

}  // namespace
}  // namespace zenosphere
