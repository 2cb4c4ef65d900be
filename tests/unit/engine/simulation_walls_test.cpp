// Walls and gravity, as a simulation has them.

#include <gtest/gtest.h>

#include "engine/simulation.hpp"

namespace zenosphere {
namespace {

using Line = Simulation<1, double>;
using Plane = Simulation<2, double>;

TEST(Walls, MakeNoNeighboursAcrossThem) {
  // Side 4: centres 0.6 and 3.4 would overlap around a ring. Between walls they bounce, each at its
  // own wall after 0.1 at speed 1, and meet in the middle.
  Line line(ShearBox<1, double>({4}, 0, 1.5, 0), {{{0.6}, {3.4}}, {{-1}, {1}}}, {1.0},
            {{}, Walls<double>{.axis = 0}});
  const auto first = line.next_collision(10).value();
  EXPECT_EQ(first.i, 0);
  EXPECT_EQ(line.wall(first.j), 0);
  EXPECT_NEAR(line.time(), 0.1, 1e-15);
  const auto second = line.next_collision(10).value();
  EXPECT_EQ(second.i, 1);
  EXPECT_EQ(line.wall(second.j), 1);
  const auto third = line.next_collision(10).value();
  EXPECT_EQ(third.i, 0);
  EXPECT_EQ(third.j, 1);
  EXPECT_NEAR(line.time(), 0.1 + 1, 1e-14);  // 2 apart, less a diameter: 2 to go with speed 2
}

TEST(Walls, GiveASphereTheirSpeedWhereTheyAreRough) {
  // Falls on the upper wall, which moves at 3, with (1, 2): leaves with (3, -1) for a restitution
  // of 1/2 and none of the slip.
  Plane disk(
      ShearBox<2, double>({10, 10}, 0, 1.5, 1), {{{5, 8.5}}, {{1, 2}}}, {1.0},
      {{},
       Walls<double>{.axis = 1, .restitution = 0.5, .tangential_restitution = 0, .speed = {0, 3}}});
  const auto collision = disk.next_collision(10).value();
  EXPECT_EQ(disk.time(), 0.5);
  EXPECT_EQ(disk.wall(collision.j), 1);
  EXPECT_EQ(collision.impact.normal_speed, 2);
  EXPECT_EQ(collision.impact.impulse, 3);
  EXPECT_EQ(disk.peculiar_velocity(0), (Vec<2, double>{{3, -1}}));
}

TEST(Walls, ReverseTheSlipWhereTheyAreElasticallyRough) {
  // Tangential restitution 1: the slip 1 - 3 = -2 becomes 2.
  Plane disk(
      ShearBox<2, double>({10, 10}, 0, 1.5, 1), {{{5, 8.5}}, {{1, 2}}}, {1.0},
      {{},
       Walls<double>{.axis = 1, .restitution = 0.5, .tangential_restitution = 1, .speed = {0, 3}}});
  disk.next_collision(10).value();
  EXPECT_EQ(disk.peculiar_velocity(0), (Vec<2, double>{{5, -1}}));
}

TEST(Gravity, LeavesTheRelativeMotionOfSpheresAlone) {
  // Both fall; they meet as without gravity, after a gap of 3 at speed 2.
  Plane disks(ShearBox<2, double>({20, 20}, 0, 5), {{{4, 5}, {8, 5}}, {{1, 0}, {-1, 0}}}, {1.0},
              {{0.25, -1}, {}});
  ASSERT_TRUE(disks.next_collision(10));
  EXPECT_NEAR(disks.time(), 1.5, 1e-14);
  EXPECT_NEAR(disks.configuration().positions[0][1], 5 - 1.5 * 1.5 / 2, 1e-14);
  EXPECT_NEAR(disks.peculiar_velocity(0)[1], -1.5, 1e-14);
  EXPECT_NEAR(disks.peculiar_velocity(0)[0], -1 + 0.25 * 1.5, 1e-14);
}

}  // namespace
}  // namespace zenosphere
