#include "engine/spheres.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace zenosphere {
namespace {

TEST(Spheres, FallOnAParabola) {
  Spheres<2, double> spheres(ShearBox<2, double>({20, 20}, 0), {{{5, 10}}, {{1, 2}}}, {{0, -1}});
  EXPECT_EQ(spheres.position_at(0, 2.0), (Vec<2, double>{{7, 12}}));  // 10 + 4 - 2
  EXPECT_EQ(spheres.velocity_at(0, 2.0), (Vec<2, double>{{1, 0}}));
  spheres.advance(0, 2.0);
  EXPECT_EQ(spheres[0].time, 2);
  EXPECT_EQ(spheres.position_at(0, 4.0), (Vec<2, double>{{9, 10}}));  // 12 + 0 - 2
}

TEST(Spheres, DoNotFallWhereTheyAreImmobile) {
  Configuration<2, double> start{{{5, 10}, {9, 10}}, {{1, 2}, {1, 2}}};
  start.grains.immobile = {1, 0};
  const Spheres<2, double> spheres(ShearBox<2, double>({20, 20}, 0), start, {{0, -1}});
  EXPECT_EQ(spheres.position_at(0, 2.0), (Vec<2, double>{{7, 14}}));
  EXPECT_EQ(spheres.velocity_at(0, 2.0), (Vec<2, double>{{1, 2}}));
  EXPECT_EQ(spheres.copy_at(0, 2.0).velocity, (Vec<2, double>{{1, 2}}));
  EXPECT_EQ(spheres.position_at(1, 2.0), (Vec<2, double>{{11, 12}}));
  EXPECT_TRUE(spheres.fall_apart(0, 1));
}

TEST(Spheres, KeepAPlaceBeyondAWallOnTheWall) {
  // A flight too far by rounding is not wrapped to the other wall.
  const Spheres<1, double> ball(ShearBox<1, double>({5}, 0, 1.5, 0), {{{0.5}}, {{-1}}}, {});
  EXPECT_EQ(ball.configuration(0, 1.0).positions[0][0], 0);
}

}  // namespace
}  // namespace zenosphere
