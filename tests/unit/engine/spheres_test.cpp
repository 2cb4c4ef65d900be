#include "engine/spheres.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace zenosphere {
namespace {

/// How many spheres are seen from sphere 0, and the last of them.
template <int Dim>
std::pair<int, Vec<Dim, double>> seen(const Spheres<Dim, double>& spheres) {
  std::pair<int, Vec<Dim, double>> result{0, {}};
  spheres.for_each_neighbour(0, spheres.cells().neighbourhood(), 0.0,
                             [&](std::int32_t, const RelativeMotion<Dim, double>& motion) {
                               ++result.first;
                               result.second = motion.dr;
                             });
  return result;
}

TEST(Spheres, FallOnAParabola) {
  const Spheres<2, double> spheres(ShearBox<2, double>({20, 20}, 0), {{{5, 10}}, {{1, 2}}},
                                   {{0, -1}});
  EXPECT_EQ(spheres.position_at(spheres[0], 2.0), (Vec<2, double>{{7, 12}}));  // 10 + 4 - 2
  EXPECT_EQ(spheres.velocity_at(spheres[0], 2.0), (Vec<2, double>{{1, 0}}));
}

TEST(Spheres, AreNeighboursAcrossAPeriodicFaceButNotAcrossWalls) {
  const Configuration<1, double> ends{{{0.6}, {3.9}}, {{0}, {0}}};
  const Spheres<1, double> ring(ShearBox<1, double>({5}, 0), ends, {});
  EXPECT_EQ(seen(ring).first, 1);
  EXPECT_NEAR(seen(ring).second[0], -1.7, 1e-15);  // 3.9 - 5 - 0.6
  EXPECT_NEAR(ring.motion(0, 1, 0).dr[0], -1.7, 1e-15);
  const Spheres<1, double> line(ShearBox<1, double>({5}, 0, 1, 0), ends, {});
  EXPECT_EQ(seen(line).first, 0);
  EXPECT_NEAR(line.motion(0, 1, 0).dr[0], 3.3, 1e-15);
}

TEST(Spheres, CrossNoFaceAtAWall) {
  // Cells of 1.25: from 1 to the left there is only the wall; to the right a face at 1.25.
  const ShearBox<1, double> box({5}, 0, 1, 0);
  const Spheres<1, double> left(box, {{{1}}, {{-1}}}, {});
  EXPECT_FALSE(left.next_crossing(left[0]).time < 1e9);
  const Spheres<1, double> right(box, {{{1}}, {{1}}}, {});
  EXPECT_EQ(right.next_crossing(right[0]).time, 0.25);
  EXPECT_EQ(right.next_crossing(right[0]).direction, 1);
  const Spheres<1, double> last(box, {{{4}}, {{1}}}, {});
  EXPECT_FALSE(last.next_crossing(last[0]).time < 1e9);
}

TEST(Spheres, CrossTheFaceTheyFallBackTo) {
  // Leaves 1.5 upwards at 1 with G = 1: highest at 2, below the face at 2.5; back at 1.25 when
  // t - t^2/2 = -1/4, that is after 1 + sqrt(1.5).
  const Spheres<1, double> ball(ShearBox<1, double>({5}, 0, 1, 0), {{{1.5}}, {{1}}}, {{-1}});
  const auto crossing = ball.next_crossing(ball[0]);
  EXPECT_NEAR(crossing.time, 1 + std::sqrt(1.5), 1e-15);
  EXPECT_EQ(crossing.direction, -1);
}

TEST(Spheres, KeepAPlaceBeyondAWallOnTheWall) {
  // A flight too far by rounding is not wrapped to the other wall.
  const Spheres<1, double> ball(ShearBox<1, double>({5}, 0, 1, 0), {{{0.5}}, {{-1}}}, {});
  EXPECT_EQ(ball.configuration(0, 1.0).positions[0][0], 0);
}

}  // namespace
}  // namespace zenosphere
