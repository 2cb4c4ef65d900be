#include "physics/oracle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "support/gas.hpp"

namespace zenosphere {
namespace {

using support::Box;
using support::Gas;
using support::State;
using support::Vector;

struct Flow {
  Vector sides;
  int spheres;
  double shear_rate;
  double restitution;
  double speed;  ///< of the start
};

/// Widths that cells have at least: 2 or 3 of them a side, or up to 5, in which spheres must be
/// given new lists again and again.
constexpr double wide = 1.5;
constexpr double narrow = 1.05;

Gas gas_of(const Flow& flow, std::uint64_t seed, double cell_width = wide) {
  return Gas(Box(flow.sides, flow.shear_rate, cell_width),
             support::random_gas(flow.spheres, flow.sides, flow.speed, seed), {flow.restitution});
}

/// A gas that begins where a flow of the same spheres at unit shear rate has come to: its images
/// are displaced from the start.
Gas displaced_gas_of(const Flow& flow, std::uint64_t seed, double cell_width, double strain) {
  Gas before = gas_of({flow.sides, flow.spheres, 1, flow.restitution, flow.speed}, seed);
  while (before.time() < strain) support::next(before);
  return Gas(Box(flow.sides, flow.shear_rate, cell_width), before.configuration(),
             {flow.restitution});
}

/// Follows a gas over many clock units, with a new oracle every few collisions per sphere.
///
/// Each collision of a sphere multiplies a small deviation by a few (twice the flight between
/// collisions, in diameters, and more in oblique ones), say 8. Rounding at the restart is about
/// 1e-15, so that four collisions per sphere lead to 1e-15 x 8^4 = 4e-12; 1e-10 leaves room for an
/// unlucky pair and is still a billion times below the time between a sphere's collisions.
void follow(Gas gas, int clock_units) {
  int rounds = 0;
  while (gas.now().units < clock_units) {
    ASSERT_NO_FATAL_FAILURE(expect_collisions_of_oracle(gas, 2 * gas.spheres(), 1e-10));
    ASSERT_LT(++rounds, 300);
  }
}

TEST(Oracle, IsRightAboutTwoSpheresHeadOn) {
  // Surfaces 3 apart, closing speed 2: contact after 1.5. With restitution 1/2 they part at 1;
  // the other way round the box of 10 they have 10 - 1 - 1 = 8 to go: contact at 1.5 + 8 = 9.5.
  const State start{{{2, 5, 5}, {6, 5, 5}}, {{1, 0, 0}, {-1, 0, 0}}};
  Oracle oracle({10, 10, 10}, 0, {0.5}, start, 0);
  const Oracle::Event first = oracle.next_collision();
  EXPECT_NEAR(first.time, 1.5, 1e-15);
  EXPECT_NEAR(first.normal_speed, 2, 1e-15);
  EXPECT_NEAR(first.gap_before, 3, 1e-15);
  const Oracle::Event second = oracle.next_collision();
  EXPECT_NEAR(second.time, 9.5, 1e-14);
  EXPECT_NEAR(second.normal_speed, 1, 1e-15);
}

TEST(Oracle, IsRightAboutTheImageBeyondTheGradientFace) {
  // Sphere 0 at the bottom, sphere 1 at the top of a box of 6, both at rest in the mean flow. The
  // lower image of sphere 1 lies at y = -0.3: 0.5 below sphere 0, so it meets with dx = sqrt(0.75).
  // It starts 2 ahead of sphere 0 and comes back at 0.5 x shear rate: time (2 - sqrt(0.75)) / 0.5.
  const State start{{{1, 0.2, 3}, {3, 5.7, 3}}, {{0, 0, 0}, {0, 0, 0}}};
  Oracle oracle({6, 6, 6}, 1, {1.0}, start, 0);
  EXPECT_NEAR(oracle.next_collision().time, (2 - std::sqrt(0.75)) / 0.5, 1e-14);
}

struct Named {
  std::string name;
  Flow flow;
  int clock_units;

  friend void PrintTo(const Named& named, std::ostream* out) { *out << named.name; }
};

class Engine : public testing::TestWithParam<Named> {};

TEST_P(Engine, AgreesWithTheOracleCollisionByCollision) {
  follow(gas_of(GetParam().flow, 7, wide), GetParam().clock_units);
}

TEST_P(Engine, AgreesWithTheOracleInNarrowCells) {
  follow(gas_of(GetParam().flow, 7, narrow), GetParam().clock_units);
}

TEST_P(Engine, AgreesWithTheOracleWhereImagesAreDisplacedFromTheStart) {
  for (const double strain : {0.27, 0.61, 0.99, 1.43}) {
    for (const double cell_width : {wide, narrow}) {
      follow(displaced_gas_of(GetParam().flow, 7, cell_width, strain), GetParam().clock_units);
    }
  }
}

TEST(Engine, GoesOnFromAConfigurationAsTheGasThatWasCut) {
  for (const double strain : {0.4, 1.7, 3.3}) {
    Gas gas = displaced_gas_of({{3.74, 3.74, 3.74}, 30, 1, 0.9, 1}, 5, wide, 0.3);
    while (gas.time() < strain) support::next(gas);
    const State cut = gas.configuration();
    Gas again(gas.box(), cut, gas.rules());
    EXPECT_EQ(again.configuration().positions, cut.positions);
    EXPECT_EQ(again.configuration().offset, cut.offset);
    const Instant<double> start = gas.now();
    for (int n = 0; n < 2 * 30; ++n) {
      const auto one = support::next(gas);
      const auto other = support::next(again);
      ASSERT_EQ(one.i, other.i);
      ASSERT_EQ(one.j, other.j);
      ASSERT_NEAR(elapsed(start, one.time, gas.box().clock_unit()), again.time(), 1e-10);
    }
  }
}

// 30 spheres: side 5.40 for a solids volume fraction of 0.1, 3.74 for 0.3.
// One clock unit is one unit of strain, the time 1 / shear rate.
INSTANTIATE_TEST_SUITE_P(
    Sheared, Engine,
    testing::Values(Named{"dilute_elastic", {{5.4, 5.4, 5.4}, 30, 1, 1, 1.5}, 4},
                    Named{"dilute_slightly_inelastic", {{5.4, 5.4, 5.4}, 30, 0.7, 0.9, 1.5}, 4},
                    Named{"dilute_inelastic", {{5.4, 5.4, 5.4}, 30, 2, 0.5, 1.5}, 6},
                    Named{"dense_elastic", {{3.74, 3.74, 3.74}, 30, 1, 1, 1.5}, 3},
                    Named{"dense_slightly_inelastic", {{3.74, 3.74, 3.74}, 30, 3, 0.9, 1.5}, 4},
                    Named{"dense_inelastic", {{3.74, 3.74, 3.74}, 30, 1, 0.5, 1.5}, 4}),
    [](const auto& named) { return named.param.name; });

// Sides of 2 to 5 narrow cells, and of unlike lengths.
INSTANTIATE_TEST_SUITE_P(
    SmallBox, Engine,
    testing::Values(Named{"of_side_2_1", {{2.1, 2.1, 2.1}, 3, 1, 0.9, 1}, 40},
                    Named{"of_side_2_9", {{2.9, 2.9, 2.9}, 10, 1, 0.9, 1}, 20},
                    Named{"of_side_3_1", {{3.1, 3.1, 3.1}, 12, 1, 0.9, 1}, 20},
                    Named{"of_side_4_2", {{4.2, 4.2, 4.2}, 20, 1, 0.9, 1}, 8},
                    Named{"of_side_6", {{6, 6, 6}, 30, 1, 0.9, 1}, 7},
                    Named{"of_3_by_5_by_4", {{3, 5, 4}, 24, 1, 0.9, 1}, 7},
                    Named{"of_5_by_3_by_2_1", {{5, 3, 2.1}, 12, 1, 0.9, 1}, 7},
                    Named{"of_2_1_by_6_by_3_5", {{2.1, 6, 3.5}, 16, 1, 0.9, 1}, 7},
                    Named{"of_5_by_3_2_by_4", {{5, 3.2, 4}, 24, 1, 0.9, 1}, 7},
                    Named{"of_4_by_2_5_by_3", {{4, 2.5, 3}, 12, 1, 0.9, 1}, 7},
                    Named{"of_3_5_by_2_2_by_5", {{3.5, 2.2, 5}, 14, 1, 0.9, 1}, 7}),
    [](const auto& named) { return named.param.name; });

INSTANTIATE_TEST_SUITE_P(Unsheared, Engine,
                         testing::Values(Named{"elastic", {{3.74, 3.74, 3.74}, 30, 0, 1, 1}, 3},
                                         Named{"inelastic", {{5.4, 5.4, 5.4}, 30, 0, 0.9, 1}, 6},
                                         Named{"of_side_2_1", {{2.1, 2.1, 2.1}, 3, 0, 0.9, 1}, 6},
                                         Named{"of_3_by_5_by_4", {{3, 5, 4}, 24, 0, 0.9, 1}, 4}),
                         [](const auto& named) { return named.param.name; });

/// Dilute gases in boxes of seven cells or more along the flow, which have no lists.
///
/// A deviation grows by twice the flight between collisions, in diameters: up to 100 at a solids
/// volume fraction of 0.01. So each sphere collides once before a restart.
void follow_without_lists(Gas gas, int clock_units) {
  ASSERT_TRUE(gas.looks_by_cells());
  while (gas.now().units < clock_units) {
    ASSERT_NO_FATAL_FAILURE(expect_collisions_of_oracle(gas, gas.spheres() / 2, 1e-10));
  }
}

class Dilute : public testing::TestWithParam<Named> {};

TEST_P(Dilute, GasAgreesWithTheOracleCollisionByCollision) {
  for (const std::uint64_t seed : {7, 8}) {
    follow_without_lists(gas_of(GetParam().flow, seed, narrow), GetParam().clock_units);
  }
}

TEST_P(Dilute, GasAgreesWithTheOracleWhereImagesAreDisplacedFromTheStart) {
  for (const double strain : {0.27, 1.43}) {
    follow_without_lists(displaced_gas_of(GetParam().flow, 7, narrow, strain),
                         GetParam().clock_units);
  }
}

INSTANTIATE_TEST_SUITE_P(
    WithoutLists, Dilute,
    testing::Values(Named{"elastic_at_0_15", {{7.5, 4.3, 4.3}, 40, 1, 1, 1.5}, 3},
                    Named{"inelastic_at_0_15", {{7.5, 4.3, 4.3}, 40, 1, 0.6, 1.5}, 5},
                    Named{"at_0_1", {{7.5, 5, 4.3}, 31, 2, 0.9, 1.5}, 6},
                    Named{"at_0_05", {{8, 6, 6}, 27, 1, 0.9, 1.5}, 10},
                    Named{"at_0_01", {{14, 9, 9}, 22, 1, 0.9, 1.5}, 20},
                    Named{"unsheared_at_0_1", {{7.5, 5, 4.3}, 31, 0, 1, 1.5}, 9},
                    Named{"unsheared_at_0_01", {{14, 9, 9}, 22, 0, 0.9, 1.5}, 20}),
    [](const auto& named) { return named.param.name; });

TEST(Engine, AgreesWithTheOracleForManyCollisionsPerSphereWithoutRestart) {
  // Elastic spheres at 0.3 amplify a deviation by about 2 per collision of a sphere (seen here), so
  // 15 collisions per sphere make 1e-15 x 2^15 = 3e-11 of rounding.
  Gas gas = gas_of({{3.74, 3.74, 3.74}, 30, 1, 1, 1}, 3);
  expect_collisions_of_oracle(gas, 15 * 30 / 2, 1e-9);
}

TEST(Engine, LosesNoSphereInANarrowBoxHoweverLongItRuns) {
  // Two cells a side: a sphere may see another one in several directions, and be mistaken in which.
  // What it has missed it meets later as an overlap, that is in the past.
  Gas gas = gas_of({{3.74, 3.74, 3.74}, 30, 1, 0.99, 1}, 2);
  for (int n = 0; n < 100'000; ++n) {
    const auto collision = support::next(gas);
    ASSERT_GT(collision.flight, -1e-9) << "collision " << collision.number;
  }
}

TEST(Engine, TellsTheGapToTheImageThatMeetsHoweverLongTheFlight) {
  // Box of 6; sphere 1 flies along x, 2.8 beside the line of sphere 0, and slowly towards it along
  // y: it passes three times and meets at the fourth. What meets is the image that was
  // 2 - 4 x 6 = -22 from sphere 0 along x, so that sqrt(22^2 + 2.8^2) - 1 = 21.1775 is to be
  // closed.
  const State start{{{1, 1, 3}, {3, 3.8, 3}}, {{0, 0, 0}, {1, -0.1, 0}}};
  Gas gas(Box({6, 6, 6}, 0), start, {1.0});
  const auto collision = support::next(gas);
  ASSERT_GT(gas.time(), 18);  // three times round the box
  EXPECT_NEAR(collision.gap_before, std::sqrt(22 * 22 + 2.8 * 2.8) - 1, 1e-13);
}

/// A start from which spheres 0 and 1 meet at `meeting`, sphere 1 in direction `normal`, with a
/// closing speed of 1, and sphere 0 then at `place`, next to faces of the box.
State start_that_meets(const Vector& place, const Vector& normal, const Box& box, double meeting) {
  State start;
  for (const int sphere : {0, 1}) {
    const Vector end = sphere == 0 ? place : place + normal;
    // Laboratory velocity: the imposed profile, at the place of the meeting, and the approach.
    Vector velocity = normal * (sphere == 0 ? 0.5 : -0.5);
    velocity[0] += box.shear_rate() * (place[1] - box.sides()[1] / 2);
    Vector position = end - velocity * meeting;
    velocity[0] -= box.shear_rate() * (position[1] - box.sides()[1] / 2);
    for (int axis = 0; axis < 3; ++axis) {
      position[axis] -= box.sides()[axis] * std::floor(position[axis] / box.sides()[axis]);
    }
    start.positions.push_back(position);
    start.velocities.push_back(velocity);
  }
  return start;
}

/// The directions of the 6 faces, 12 edges and 8 corners of a cube.
std::vector<Vector> directions() {
  std::vector<Vector> all;
  for (const int x : {-1, 0, 1}) {
    for (const int y : {-1, 0, 1}) {
      for (const int z : {-1, 0, 1}) {
        Vector direction{{double(x), double(y), double(z)}};
        if (x != 0 || y != 0 || z != 0) {
          all.push_back(direction * (1 / std::sqrt(dot(direction, direction))));
        }
      }
    }
  }
  return all;
}

TEST(Engine, LetsPairsMeetAcrossEveryFaceEdgeAndCornerWhereTheyWereAimed) {
  // At 0.7 the upper images are displaced by 0.7 x 5 x rate: 0, 3.5 or 8.75 = 5 + 3.75.
  const double meeting = 0.7;
  for (const double rate : {0.0, 1.0, 2.5}) {
    const Box box({5, 5, 5}, rate);
    for (const Vector& normal : directions()) {
      Vector place;
      for (int axis = 0; axis < 3; ++axis) {
        place[axis] = normal[axis] == 0 ? 2.2 : normal[axis] > 0 ? 4.9 : 0.1;
      }
      Gas gas(box, start_that_meets(place, normal, box, meeting), {1.0});
      const auto collision = gas.next_collision(1);
      ASSERT_TRUE(collision) << normal[0] << ' ' << normal[1] << ' ' << normal[2];
      EXPECT_NEAR(elapsed({}, collision->time, box.clock_unit()), meeting, 1e-13);
      EXPECT_NEAR(collision->impact.normal_speed, 1, 1e-13);
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(collision->impact.normal[axis], normal[axis], 1e-13);
      }
    }
  }
}

}  // namespace
}  // namespace zenosphere
