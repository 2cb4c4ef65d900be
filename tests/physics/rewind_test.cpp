#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/simulation.hpp"
#include "model/real.hpp"
#include "support/gas.hpp"
#include "support/run_text.hpp"

namespace zenosphere {
namespace {

template <class Real>
class Rewind : public testing::Test {};
using Reals = testing::Types<double, Extended, Quad, Digits>;
TYPED_TEST_SUITE(Rewind, Reals);

/// Sticking rods, around a ring of 7.5.
template <class Real>
Simulation<1, Real> three_sticking_rods() {
  const auto number = from_decimal<Real>;
  return Simulation<1, Real>(
      ShearBox<1, Real>({Real(7.5)}, 0),
      {{{Real(0)}, {number(2.87)}, {number(5.36)}}, {{Real(-1)}, {number(0.3)}, {number(0.2)}}},
      {Real(0), OverlapRule::rewind});
}

// Rods 2 and 0 meet around the ring: 7.5 - 5.36 - 1 = 1.14 at 1.2, at the time 0.95. They stick
// with v = (0.2 - 1)/2 = -0.4. Rod 1 is at 3.155 then, rod 2 at 5.55: 1.395 to go at 0.7, until
// 0.95 + 1.395/0.7 = 103/35 = 2.942857. There all three come together, with v = -0.5/3.
TYPED_TEST(Rewind, LetsRodsThatHaveStuckGoOnToTheirNextContact) {
  using Real = TypeParam;
  auto rods = three_sticking_rods<Real>();
  const Real rounding = 64 * std::numeric_limits<Real>::epsilon();
  const auto first = rods.next_collision(50).value();
  EXPECT_LT(abs(first.flight - Real(95) / 100), rounding);
  auto collision = first;
  while (collision.i != 1 && collision.j != 1 && rods.collisions() < 100) {
    collision = rods.next_collision(50).value();
    EXPECT_GE(collision.flight, -rods.longest_rewind());
  }
  EXPECT_LT(abs(exactly_since_start(collision.time, Real(1)) - Real(103) / 35), rounding);
}

TYPED_TEST(Rewind, EndsThreeStickingRodsAtTheirCommonVelocity) {
  using Real = TypeParam;
  auto rods = three_sticking_rods<Real>();
  for (int call = 0; call < 2000 && !rods.has_reached(50); ++call) {
    if (const auto collision = rods.next_collision(50)) {
      ASSERT_GE(collision->flight, -rods.longest_rewind());
    }
  }
  for (const int rod : {0, 1, 2}) {
    EXPECT_LT(abs(rods.peculiar_velocity(rod)[0] + Real(1) / 6),
              16 * std::numeric_limits<Real>::epsilon());
  }
}

/// Disks on a regular polygon of that radius, that fly to its centre at speed 1.
template <class Real>
Simulation<2, Real> polygon_of(int disks, int radius, double restitution) {
  Configuration<2, Real> start;
  for (int k = 0; k < disks; ++k) {
    const double angle = 2 * std::numbers::pi * k / disks + 0.3;
    const Vec<2, Real> outward{{Real(std::cos(angle)), Real(std::sin(angle))}};
    start.positions.push_back(outward * Real(radius) + Vec<2, Real>{{Real(10), Real(10)}});
    start.velocities.push_back(outward * Real(-1));
  }
  return Simulation<2, Real>(ShearBox<2, Real>({Real(20), Real(20)}, 0), start,
                             {Real(restitution), OverlapRule::rewind});
}

// They touch where the polygon has sides of 1: n of them on a circle of radius 1 / (2 sin(pi/n)).
// No momentum is left: from then on all speeds are rounding, and a contact that is overlap over
// closing speed may lie anywhere.
TYPED_TEST(Rewind, LeavesDisksThatHaveComeToRestWhereAndWhenTheyMet) {
  using Real = TypeParam;
  for (const int disks : {5, 6, 7, 8}) {
    auto polygon = polygon_of<Real>(disks, 3, 0);
    const double radius = 0.5 / std::sin(std::numbers::pi / disks);
    double latest = 0;
    for (int call = 0; call < 2000 && !polygon.has_reached(30) && !polygon.is_at_rest(); ++call) {
      polygon.next_collision(30);
      EXPECT_GE(polygon.time(), std::min(latest, 3 - radius) - 1e-5);
      latest = std::max(latest, polygon.time());
    }
    for (const auto& place : polygon.configuration().positions) {
      const auto [x, y] = std::array{double(place[0]) - 10, double(place[1]) - 10};
      EXPECT_NEAR(std::hypot(x, y), radius, 1e-5) << disks << " disks";
    }
  }
}

// At 0.05 they come to speeds of rounding as well. (In more digits than those of the start, speeds
// of 1e-16 are no rounding.)
TEST(RewindInDouble, NeverSetsTheClockBackVisiblyWhereDisksComeToRest) {
  for (const int disks : {5, 6, 7, 8}) {
    for (const double restitution : {0.0, 0.05}) {
      auto polygon = polygon_of<double>(disks, 2, restitution);
      double latest = 0;
      for (int call = 0; call < 1000 && !polygon.has_reached(100); ++call) {
        polygon.next_collision(100);
        ASSERT_GE(polygon.time(), latest - 1e-4) << disks << " disks, e = " << restitution;
        latest = std::max(latest, polygon.time());
        if (polygon.is_at_rest()) break;
      }
    }
  }
}

/// Twenty spheres one behind the other, at a line fraction of 0.3.
std::string row(int dimension, double restitution, std::uint64_t seed, const std::string& more) {
  constexpr int count = 20;
  support::Dice dice(seed);
  std::vector<double> places, gaps;
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += gaps.emplace_back(-std::log(1 - dice.between(0, 1)));
  const double room = count / 0.3 - count - 1;
  std::string positions, velocities;
  const std::string beside = dimension == 1 ? "" : dimension == 2 ? ", 4" : ", 4, 4";
  const std::string still = dimension == 1 ? "" : dimension == 2 ? ", 0" : ", 0, 0";
  double x = 0.5;
  for (const double gap : gaps) {
    positions += fmt::format("[{}{}], ", x, beside);
    velocities += fmt::format("[{}{}], ", dice.between(-1, 1), still);
    x += 1 + gap * room / sum;
  }
  const std::string others = dimension == 1 ? "" : dimension == 2 ? ", 8" : ", 8, 8";
  return fmt::format(
      "[system]\ndimension = {}\nspheres = {}\nrestitution = {}\nsides = [{}{}]\n"
      "[start]\narrangement = \"given\"\npositions = [{}]\nvelocities = [{}]\n"
      "[run]\ntime = 60\ncollisions = 2000\n{}",
      dimension, count, restitution, count / 0.3, others, positions, velocities, more);
}

struct Row {
  std::string name;
  int dimension;
  std::string more;

  friend void PrintTo(const Row& row, std::ostream* out) { *out << row.name; }
};

class RowOfSpheres : public testing::TestWithParam<Row> {};

// The self-check tests the bound at every collision.
TEST_P(RowOfSpheres, NeverStepsBackBeyondTheBoundHoweverInelastic) {
  const auto& [name, dimension, more] = GetParam();
  for (const double restitution : {0.0, 1e-15, 1e-12, 1e-9}) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const Summary summary = test::run_text(row(dimension, restitution, seed, more));
      ASSERT_FALSE(summary.self_check)
          << *summary.self_check << ", e = " << restitution << ", seed " << seed;
      EXPECT_GT(summary.collisions, 10);
    }
  }
}

const std::string alone = "[drive]\nkind = \"none\"\n";

INSTANTIATE_TEST_SUITE_P(
    Twenty, RowOfSpheres,
    testing::Values(
        Row{"rods", 1, alone}, Row{"discs", 2, alone}, Row{"spheres", 3, alone},
        Row{"rods_with_contact_duration", 1, alone + "[collision]\ncontact_duration = 1e-3\n"},
        Row{"discs_with_contact_duration", 2, alone + "[collision]\ncontact_duration = 1e-3\n"},
        Row{"rods_in_quad", 1, alone + "[collision]\nprecision = \"quad\"\n"},
        Row{"kicked_rods", 1,
            "[drive]\nkind = \"random\"\nnoise_strength = 0.1\nkick_interval = 0.5\n"},
        Row{"rods_between_walls", 1, alone + "[walls]\naxis = \"x\"\nrestitution = 0\n"},
        Row{"falling_rods", 1, alone + "[gravity]\nacceleration = [0.1]\n"}),
    [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace zenosphere
