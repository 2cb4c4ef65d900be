#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/simulation.hpp"
#include "support/gas.hpp"

namespace zenosphere {
namespace {

using Place = Vec<2, double>;
using Disks = Simulation<2, double>;

constexpr double side = 9;     // periodic along x
constexpr double height = 14;  // of the upper wall
constexpr int pegs = 7;
constexpr int rows = 3;
constexpr int in_row = 5;
constexpr double pull_x = 0.15, pull_y = -1;

/// A row of immobile disks of several sizes at rest, and others that fall onto it and along it.
Disks falling_disks(double restitution) {
  support::Dice dice(4);
  Configuration<2, double> start;
  const auto add = [&](const Place& place, double diameter, bool immobile) {
    start.positions.push_back(place);
    start.velocities.push_back(immobile ? Place{}
                                        : Place{{dice.between(-1, 1), dice.between(-1, 1)}});
    start.grains.diameters.push_back(diameter);
    start.grains.masses.push_back(diameter * diameter);
    start.grains.kinds.push_back(0);
    start.grains.immobile.push_back(immobile);
  };
  for (int row = 0; row < rows; ++row) {
    for (int n = 0; n < in_row; ++n) {
      add({{0.7 + 1.7 * n + 0.3 * row, 4 + 1.7 * row}}, dice.between(0.8, 1.3), false);
    }
  }
  for (int n = 0; n < pegs; ++n) {
    add({{0.6 + 1.25 * n, 1.5 + 0.5 * (n % 3)}}, dice.between(0.7, 1.1), true);
  }
  const ShearBox<2, double> box({{side, height}}, 0, 2, 1);
  const Surroundings<2, double> surroundings{
      {{pull_x, pull_y}}, Walls<double>{.axis = 1, .restitution = restitution}, false};
  return Disks(box, start, {.restitution = restitution}, surroundings);
}

Collision<2, double> next(Disks& disks) {
  for (;;) {
    if (const auto collision = disks.next_collision(1e9)) return *collision;
  }
}

/// All pairs in small steps: the first one that gets closer than it may.
struct Contact {
  double time;
  std::int32_t i, j;
};

class SmallSteps {
 public:
  explicit SmallSteps(const Disks& disks) : state_(disks.configuration()) {}

  Contact next(double step) const {
    const auto count = static_cast<std::int32_t>(state_.positions.size());
    for (double from = 0;; from += step) {
      Contact first{from + step, -1, -1};
      for (std::int32_t j = 0; j < count + 2; ++j) {
        for (std::int32_t i = 0; i < std::min(j, count); ++i) {
          if (!(excess(i, j, first.time) < 0) || excess(i, j, from) < -1e-9) continue;
          if (excess(i, j, from) < excess(i, j, first.time)) continue;  // they part
          first = {crossing_of(i, j, from, first.time), i, j};
        }
      }
      if (first.i >= 0) return first;
    }
  }

 private:
  Place place(std::int32_t i, double t) const {
    const auto at = static_cast<std::size_t>(i);
    const Place flown = state_.positions[at] + state_.velocities[at] * t;
    if (state_.grains.is_immobile(i)) return flown;
    return flown + Place{{pull_x, pull_y}} * (t * t / 2);
  }

  /// Distance of two disks, or of a disk and a wall, less that of their contact.
  double excess(std::int32_t i, std::int32_t j, double t) const {
    const auto count = static_cast<std::int32_t>(state_.positions.size());
    const double radius = state_.grains.radius(i);
    if (j >= count) {
      if (state_.grains.is_immobile(i)) return 1;
      const double y = place(i, t)[1];
      return (j == count ? y : height - y) - radius;
    }
    if (state_.grains.is_immobile(i) && state_.grains.is_immobile(j)) return 1;
    Place between = place(j, t) - place(i, t);
    between[0] -= side * std::round(between[0] / side);
    return std::hypot(between[0], between[1]) - radius - state_.grains.radius(j);
  }

  double crossing_of(std::int32_t i, std::int32_t j, double from, double to) const {
    for (int half = 0; half < 60; ++half) {
      const double middle = from + (to - from) / 2;
      (excess(i, j, middle) < 0 ? to : from) = middle;
    }
    return to;
  }

  Configuration<2, double> state_;
};

TEST(BumpyBase, HasTheContactsThatSmallStepsSee) {
  constexpr int contacts = 400;
  Disks disks = falling_disks(0.98);
  const std::int32_t movers = rows * in_row;
  int with_pegs = 0;
  for (int n = 0; n < contacts; ++n) {
    const SmallSteps steps(disks);
    const double from = disks.time();
    const auto collision = next(disks);
    const Contact expected = steps.next(1e-3);
    ASSERT_EQ(std::pair(collision.i, collision.j), std::pair(expected.i, expected.j)) << n;
    ASSERT_NEAR(disks.time() - from, expected.time, 1e-9) << n;
    with_pegs += collision.j >= movers && collision.j < movers + pegs;
  }
  EXPECT_GT(with_pegs, contacts / 8);
}

/// Kinetic energy and that of gravity along y.
double energy_of(const Disks& disks) {
  const auto state = disks.configuration();
  double sum = 0;
  for (std::int32_t i = 0; i < disks.spheres(); ++i) {
    if (disks.grains().is_immobile(i)) continue;
    const auto at = static_cast<std::size_t>(i);
    const Place& velocity = state.velocities[at];
    const double way_x = state.positions[at][0] + side * state.boxes[at][0];
    sum += disks.grains().mass(i) *
           (dot(velocity, velocity) / 2 - pull_y * state.positions[at][1] - pull_x * way_x);
  }
  return sum;
}

TEST(BumpyBase, OfElasticDisksKeepsTheEnergyThatGravityGives) {
  Disks disks = falling_disks(1);
  const double before = energy_of(disks);
  const auto pegs_before = disks.configuration().positions;
  for (int n = 0; n < 20000; ++n) next(disks);
  EXPECT_NEAR(energy_of(disks), before, 1e-9 * std::abs(before));
  const auto after = disks.configuration().positions;
  for (std::size_t i = rows * in_row; i < after.size(); ++i) EXPECT_EQ(after[i], pegs_before[i]);
}

TEST(BumpyBase, EndsTheHopsOfABallOnTopOfAPegAsAFloorDoes) {
  // Dropped from 1/2 above the top, gravity 1: on it at 1 with the speed v0 = 1; then hops of
  // 2 v0 e^n, which end at 1 + 2 v0 e / (1 - e) = 3.
  Configuration<2, double> start;
  start.positions = {{{4, 3.5}}, {{4, 2}}};
  start.velocities = {{}, {}};
  start.grains.immobile = {0, 1};
  const ShearBox<2, double> box({{8, 8}}, 0, 2, 1);
  const Surroundings<2, double> surroundings{{{0, -1}}, Walls<double>{.axis = 1}, false};
  Disks disks(box, start, {.restitution = 0.5}, surroundings);
  double time = 0;
  double last_gap = 1;
  for (int n = 0; n < 20; ++n) {
    const auto collision = next(disks);
    EXPECT_EQ(collision.j, 1);
    time = disks.time();
    // Its apex, 1/2 4^-n above the top: far above the rounding of places for so long.
    EXPECT_NEAR(collision.gap_before, std::pow(0.25, n) / 2, 1e-15);
    EXPECT_LT(collision.gap_before, last_gap);
    last_gap = collision.gap_before;
  }
  EXPECT_NEAR(time, 3 - std::pow(0.5, 18), 1e-9);
}

}  // namespace
}  // namespace zenosphere
