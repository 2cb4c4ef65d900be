// Starts that the case writes itself.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "unit/start/start_fixture.hpp"

namespace zenosphere {
namespace {

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

// The plate is accelerated upwards from time 0: with and without gravity it pushes what touches it,
// elastic or not.
TEST(GivenStart, SphereOnAPlateStaysThereIfItMayRest) {
  const auto on_a_plate = [](const std::string& resting_flight, const std::string& gravity) {
    std::vector<std::string> plate{"walls.axis=y",
                                   "walls.restitution=1",
                                   "walls.motion=sinusoidal",
                                   "walls.amplitude=0.1",
                                   "walls.frequency=1",
                                   "start.velocities=[[0, 0], [1, 0]]",
                                   "walls.resting_flight=" + resting_flight};
    if (!gravity.empty()) plate.push_back("gravity.acceleration=" + gravity);
    return problem_at("[[1, 0.5], [4, 2]]", plate);
  };
  EXPECT_EQ(on_a_plate("1e-4", "[0, -1]"), "");
  EXPECT_EQ(on_a_plate("1e-4", ""), "");
  const std::string refused =
      "start.positions: sphere 0 at (1, 0.5) rests on a wall, which begins to push it (contacts "
      "of hard spheres are instants: the clock would stand at 0); lift it, or give it a "
      "walls.resting_flight";
  EXPECT_EQ(on_a_plate("0", "[0, -1]"), refused);
  EXPECT_EQ(on_a_plate("0", ""), refused);
  EXPECT_EQ(on_a_plate("0", "[0, 4]"), "");  // (2 pi)^2 0.1 = 3.9: it falls up faster
}

TEST(GivenStart, OverlappingSpheresAreNamedAndTouchingOnesPass) {
  EXPECT_EQ(problem_at("[[1, 1], [1.93, 1]]"),
            "start.positions: spheres 0 and 1 overlap (distance 0.93 diameters); move them apart");
  EXPECT_EQ(problem_at("[[1, 1], [2, 1]]"), "");
  EXPECT_EQ(problem_at("[[1, 1], [1.9999999999995, 1]]"), "");  // 5e-13 is rounding, 5e-12 is not
  EXPECT_NE(problem_at("[[1, 1], [1.999999999995, 1]]"), "");
}

TEST(GivenStart, RoundingOfPlacesInALongBoxIsNoOverlap) {
  // 524288 is 2^19: from there on a place has one bit less, 1.2e-10, and these are 1 - 5.8e-11
  // apart.
  const std::vector<std::string> wide{"system.sides=[1048576, 8]"};
  EXPECT_EQ(problem_at("[[524287.2, 1], [524288.2, 1]]", wide), "");
  EXPECT_NE(problem_at("[[524287.2, 1], [524288.199999999, 1]]", wide), "");  // 1e-9
}

TEST(GivenStart, SpheresOverlapAcrossPeriodicFacesAndNotAcrossWalls) {
  EXPECT_EQ(problem_at("[[9.75, 7.75], [0.25, 0.25]]"),  // 0.5 sqrt(2)
            "start.positions: spheres 0 and 1 overlap (distance 0.7071067811865 diameters); move "
            "them apart");
  const std::vector<std::string> walls{"walls.axis=x", "walls.restitution=1",
                                       "system.sides=[2, 8]"};
  EXPECT_EQ(problem_at("[[0.5, 1], [1.5, 1]]", walls), "");
}

}  // namespace
}  // namespace zenosphere
