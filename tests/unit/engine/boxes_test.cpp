// Through how many boxes spheres have come: their places in the infinite system.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/simulation.hpp"
#include "support/gas.hpp"

namespace zenosphere {
namespace {

using support::Box;
using support::Gas;
using support::State;
using support::Vector;

/// Where the spheres are in the laboratory without images, and how fast.
struct Unwrapped {
  std::vector<Vector> places;
  std::vector<Vector> velocities;
};

Unwrapped unwrapped(const Gas& gas) {
  const State state = gas.configuration();
  const Vector& sides = gas.box().sides();
  Unwrapped result;
  for (std::size_t i = 0; i < state.positions.size(); ++i) {
    Vector place = state.positions[i];
    for (int axis = 0; axis < 3; ++axis) place[axis] += state.boxes[i][axis] * sides[axis];
    place[0] += state.boxes[i][1] * state.offset;
    Vector velocity = state.velocities[i];
    velocity[0] += gas.box().profile(place);
    result.places.push_back(place);
    result.velocities.push_back(velocity);
  }
  return result;
}

/// From each collision to the next every sphere flies freely, whatever faces it comes through.
///
/// Positions in boxes of 6 are rounded to 1e-15, and offsets to as much times the boxes up.
void expect_free_flights(Gas& gas, int collisions) {
  const Vector& pull = gas.surroundings().acceleration;
  double farthest = 0;
  for (int n = 0; n < collisions; ++n) {
    const Unwrapped before = unwrapped(gas);
    const Instant<double> start = gas.now();
    support::next(gas);
    const Unwrapped after = unwrapped(gas);
    const double flight = elapsed(start, gas.now(), gas.box().clock_unit());
    for (std::size_t i = 0; i < before.places.size(); ++i) {
      const Vector expected =
          before.places[i] + before.velocities[i] * flight + pull * (flight * flight / 2);
      for (int axis = 0; axis < 3; ++axis) {
        const double place = after.places[i][axis];
        farthest = std::max(farthest, std::abs(place));
        ASSERT_NEAR(place, expected[axis], 1e-13 * (10 + std::abs(place)))
            << "sphere " << i << ", axis " << axis << ", collision " << n;
      }
    }
  }
  EXPECT_GT(farthest, 3 * gas.box().sides()[0]);
}

State gas_in(const Vector& sides, double offset) {
  State start = support::random_gas(20, sides, 1, 4);
  start.offset = offset;
  return start;
}

TEST(Boxes, AreCountedOverManyTurnsOfTheLayers) {
  const Vector sides{{4, 6, 5}};
  for (const double offset : {0.0, 1.3, -2.0}) {
    Gas gas(Box(sides, 3), gas_in(sides, offset), {1.0, OverlapRule::immediate});
    expect_free_flights(gas, 2000);
    EXPECT_GT(gas.now().units, 5 * gas.box().cells()[0]);
  }
}

TEST(Boxes, AreCountedWithoutShear) {
  const Vector sides{{4, 6, 5}};
  for (const double offset : {0.0, 1.3, -2.0}) {
    Gas gas(Box(sides, 0), gas_in(sides, offset), {1.0, OverlapRule::immediate});
    expect_free_flights(gas, 3000);
  }
}

TEST(Boxes, AreCountedInAFrameThatFalls) {
  const Vector sides{{4, 6, 5}};
  for (const double offset : {0.0, 1.3}) {
    Gas gas(Box(sides, 0), gas_in(sides, offset), {1.0, OverlapRule::immediate},
            {.acceleration = {{0.3, -0.7, 0.1}}});
    expect_free_flights(gas, 500);
  }
}

TEST(Boxes, AreCountedInLeapsOverManyOfThem) {
  // Sphere 1 flies along x, 2.8 beside the line of sphere 0, and towards it so slowly that it
  // passes hundreds of times: in leaps.
  const State start{{{1, 1, 3}, {3, 3.8, 3}}, {{0, 0, 0}, {1, -0.001, 0}}};
  Gas gas(Box({6, 6, 6}, 0), start, {1.0});
  support::next(gas);
  const double time = gas.time();
  EXPECT_GT(time, 1500);
  EXPECT_NEAR(unwrapped(gas).places[1][0], 3 + time, 1e-12 * time);
  EXPECT_NEAR(unwrapped(gas).places[1][1], 3.8 - 0.001 * time, 1e-12 * time);
}

}  // namespace
}  // namespace zenosphere
