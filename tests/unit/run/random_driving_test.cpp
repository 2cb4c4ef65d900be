#include "run/random_driving.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

namespace zenosphere {
namespace {

Case kicked(int dimension) {
  Case values;
  values.system.dimension = dimension;
  values.drive = {.kind = DriveKind::random, .noise_strength = 2, .kick_interval = 0.125};
  return values;
}

/// Spheres at rest on a line, two diameters apart.
template <int Dim>
Simulation<Dim, double> resting(int spheres, std::optional<int> closed_axis = std::nullopt) {
  Vec<Dim, double> sides;
  for (int axis = 0; axis < Dim; ++axis) sides[axis] = axis == 0 ? 2.0 * spheres + 2 : 4;
  Configuration<Dim, double> start;
  for (int i = 0; i < spheres; ++i) {
    Vec<Dim, double> place = sides * 0.5;
    place[0] = 2 * i + 1;
    start.positions.push_back(place);
    start.velocities.push_back({});
  }
  Surroundings<Dim, double> surroundings;
  if (closed_axis) surroundings.walls = Walls<double>{.axis = *closed_axis};
  return {ShearBox<Dim, double>(sides, 0, 1.5, closed_axis), start, {1.0}, surroundings};
}

template <int Dim>
Vec<Dim, double> momentum(const Simulation<Dim, double>& gas) {
  Vec<Dim, double> sum;
  for (int i = 0; i < gas.spheres(); ++i) sum += gas.peculiar_velocity(i);
  return sum;
}

TEST(RandomDriving, IsNeverDueWithoutKicks) {
  const Case values;
  RandomDriving<3, double> driving(values);
  EXPECT_EQ(driving.next_kick(), std::numeric_limits<double>::infinity());
}

TEST(RandomDriving, IsDueAtMultiplesOfTheInterval) {
  auto gas = resting<2>(2);
  Measurements<2, double> measurements(gas, 0);
  RandomDriving<2, double> driving(kicked(2));
  for (int kick = 1; kick <= 10; ++kick) {
    EXPECT_EQ(driving.next_kick(), kick * 0.125);
    driving.kick(gas, measurements);
  }
}

// Of 10000 components each of variance 2 x 0.125 = 1/4; the sum of squares scatters by
// sqrt(2/10000) = 1.4 %; the removed mean takes a ten-thousandth.
TEST(RandomDriving, GivesEachComponentTheVarianceOfTheNoiseTimesTheInterval) {
  auto gas = resting<2>(10000);
  Measurements<2, double> measurements(gas, 0);
  RandomDriving<2, double> driving(kicked(2));
  driving.kick(gas, measurements);
  for (int axis = 0; axis < 2; ++axis) {
    double squares = 0;
    for (int i = 0; i < gas.spheres(); ++i) squares += std::pow(gas.peculiar_velocity(i)[axis], 2);
    EXPECT_NEAR(squares / gas.spheres(), 0.25, 0.07 * 0.25);
    EXPECT_NEAR(momentum(gas)[axis], 0, 1e-10);  // 1e4 roundings of 1e-16
  }
}

TEST(RandomDriving, KeepsTheMomentumOfSpheresOfDifferentMasses) {
  Configuration<1, double> start{{{1}, {4}, {7}}, {{0}, {0}, {0}}};
  start.grains.diameters = {1, 1, 1};
  start.grains.masses = {1, 2, 5};
  Simulation<1, double> gas(ShearBox<1, double>({10}, 0, 1.5), start, {1.0});
  Measurements<1, double> measurements(gas, 0);
  RandomDriving<1, double> driving(kicked(1));
  driving.kick(gas, measurements);
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += gas.grains().mass(i) * gas.peculiar_velocity(i)[0];
  EXPECT_NEAR(sum, 0, 1e-15);
  EXPECT_NE(gas.peculiar_velocity(0)[0], 0);
}

TEST(RandomDriving, LeavesTheMomentumToTheWallsWhereThereAreSome) {
  Case values = kicked(1);
  values.walls.axis = Axis::x;
  auto gas = resting<1>(100, 0);
  Measurements<1, double> measurements(gas, 0);
  RandomDriving<1, double> driving(values);
  driving.kick(gas, measurements);
  // Of variance 100/4: one in a hundred lies closer to 0 than 0.06.
  EXPECT_GT(std::abs(momentum(gas)[0]), 0.06);
}

TEST(RandomDriving, RepeatsItselfWithTheSeedOfTheCase) {
  Case values = kicked(1);
  double speed[3] = {};
  for (const int run : {0, 1, 2}) {
    values.start.seed = run < 2 ? 1 : 2;
    auto gas = resting<1>(3);
    Measurements<1, double> measurements(gas, 0);
    RandomDriving<1, double> driving(values);
    driving.kick(gas, measurements);
    speed[run] = gas.peculiar_velocity(0)[0];
  }
  EXPECT_EQ(speed[0], speed[1]);
  EXPECT_NE(speed[0], speed[2]);
}

}  // namespace
}  // namespace zenosphere
