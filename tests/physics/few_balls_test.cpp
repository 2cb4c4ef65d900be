#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>

#include "collapse/arrest_criterion.hpp"
#include "collapse/separation_criterion.hpp"
#include "support/gas.hpp"

namespace zenosphere {
namespace {

using support::Gas;
using support::Record;
using support::State;
using support::Vector;

constexpr double ball_box_side = 20;
constexpr double hit_threshold = 1e-16;

/// Three balls on a line at 0, 1 and 3 with speeds 1, 0 and 1/8, the first one at `place`.
State three_balls(const Vector& place, const Vector& direction) {
  const double along[] = {0, 1, 3};
  const double speed[] = {1, 0, 0.125};
  State start;
  for (int ball = 0; ball < 3; ++ball) {
    Vector position = place + direction * along[ball];
    for (int axis = 0; axis < 3; ++axis) {
      position[axis] -= ball_box_side * std::floor(position[axis] / ball_box_side);
    }
    start.positions.push_back(position);
    start.velocities.push_back(direction * speed[ball]);
  }
  return start;
}

struct Line {
  std::string name;
  Vector place;
  Vector direction;

  friend void PrintTo(const Line& line, std::ostream* out) { *out << line.name; }
};

class ThreeBalls : public testing::TestWithParam<Line> {};

// With restitution 0.05 each collision scales the relative speed by 0.4, the gap by 0.125 and the
// time step by 0.3125; the second collision comes after a gap of 1 at speed 0.4: a flight of 2.5.
TEST_P(ThreeBalls, CollapseByTheRationalFactors) {
  Gas gas(support::cube(ball_box_side), three_balls(GetParam().place, GetParam().direction),
          {0.05});
  const Record first = gas.next_collision(10).value();
  EXPECT_NEAR(first.flight, 0, 1e-14);
  EXPECT_NEAR(first.impact.normal_speed, 1, 1e-14);
  double speed = 1;
  double gap = 1;
  double flight = 2.5;
  for (int n = 2; n <= 12; ++n) {
    const Record collision = gas.next_collision(10).value();
    speed *= 0.4;
    // Even collisions are those of the leading pair.
    EXPECT_EQ(collision.i, n % 2 == 0 ? 1 : 0);
    EXPECT_EQ(collision.j, n % 2 == 0 ? 2 : 1);
    // Speeds below 1 are rounded by 1e-16 at each collision; so are the axes of an oblique line.
    EXPECT_NEAR(collision.impact.normal_speed, speed, 1e-14);
    // A coordinate near 20 has an ulp of 3.6e-15; three of them and both balls: 2e-14.
    EXPECT_NEAR(collision.gap_before, gap, 2e-14);
    EXPECT_NEAR(collision.flight, flight, 2e-14 * (1 / speed) + 1e-13);
    gap *= 0.125;
    flight *= 0.3125;
  }
}

// The gap after collision n is 8^-(n-1): 4.4e-16 after 18, 5.6e-17 after 19. Coordinates of 1e-15
// in the last place round it to zero or to an ulp for the first time some collisions around that.
TEST_P(ThreeBalls, MeetTheSeparationCriterionWhenTheSeriesEnds) {
  Gas gas(support::cube(ball_box_side), three_balls(GetParam().place, GetParam().direction),
          {0.05});
  SeparationCriterion<3, double> criterion(hit_threshold, gas.box().clock_unit());
  // Collision 1 itself is at gap 0; it has no collision before it and is not counted.
  while (criterion.hits() == 0 && gas.collisions() < 30) {
    criterion.observe(gas.next_collision(10).value());
  }
  ASSERT_EQ(criterion.hits(), 1);
  EXPECT_GE(criterion.first_collision().value(), 16);
  EXPECT_LE(criterion.first_collision().value(), 22);
  // The series of flights is 2.5 / (1 - 0.3125) = 40/11; after 16 collisions 9.5e-8 of it is left,
  // and a gap wrong by 1e-15 at a speed of 0.4^17 = 1.7e-7 shifts the time by 6e-9.
  EXPECT_NEAR(criterion.first_time().value(), 40.0 / 11, 5e-7);
}

const double cosine = 1 / std::sqrt(3.0);  // of the diagonal with each axis

// 19.2 + 1 lies beyond a face at 20, and 0.8 - 1 below one at 0.
INSTANTIATE_TEST_SUITE_P(
    Along, ThreeBalls,
    testing::Values(Line{"x", {8, 10, 10}, {1, 0, 0}},
                    Line{"diagonal", {8.3, 7.1, 9.4}, {cosine, cosine, cosine}},
                    Line{"a_3_4_5_direction", {8.3, 9.7, 10.1}, {0.6, 0.8, 0}},
                    Line{"x_across_upper_face", {19.2, 10, 10}, {1, 0, 0}},
                    Line{"x_across_lower_face", {0.8, 10, 10}, {-1, 0, 0}},
                    Line{"y_across_upper_face", {10, 19.2, 10}, {0, 1, 0}},
                    Line{"y_across_lower_face", {10, 0.8, 10}, {0, -1, 0}},
                    Line{"z_across_upper_face", {10, 10, 19.2}, {0, 0, 1}},
                    Line{"z_across_lower_face", {10, 10, 0.8}, {0, 0, -1}},
                    Line{"diagonal_across_corner", {19.2, 19.2, 19.2}, {cosine, cosine, cosine}}),
    [](const auto& line) { return line.param.name; });

TEST(ThreeBallsOnALine, DoNotCollapseAboveTheKnownRestitution) {
  // The limit is 7 - 4 sqrt(3) = 0.0718. At 0.2 the balls part after a few collisions.
  Gas gas(support::cube(ball_box_side), three_balls({8, 10, 10}, {1, 0, 0}), {0.2});
  while (gas.next_collision(10)) ASSERT_LT(gas.collisions(), 10);
  EXPECT_TRUE(gas.has_reached(10));
}

/// Three balls on a circle around `centre`, 120 degrees apart, with unit speeds towards it.
State triple(const Vector& centre, double radius) {
  State start;
  const double half = 0.5 * std::sqrt(3.0);
  for (const Vector& corner :
       {Vector{{1, 0, 0}}, Vector{{-0.5, half, 0}}, Vector{{-0.5, -half, 0}}}) {
    start.positions.push_back(centre + corner * radius);
    start.velocities.push_back(corner * -1.0);
  }
  return start;
}

// The balls meet at the corners of a triangle of side 1, all three pairs at once: exact arithmetic
// would find every gap zero after collision 1. Computed gaps are zero up to an ulp or a few of the
// coordinates, so that about half of the triples find one at or below the threshold of 1e-16.
TEST(Criteria, ElasticTripleMeetsSeparationButNeverArrest) {
  constexpr int triples = 100;
  int met = 0;
  for (int n = 0; n < triples; ++n) {
    const double radius = 1.5 + 0.01 * n;
    Gas gas(support::cube(ball_box_side), triple({10, 9 + 0.013 * n, 10}, radius), {1.0});
    SeparationCriterion<3, double> separation(hit_threshold, gas.box().clock_unit());
    // Least window, and no pair needs to come again.
    ArrestCriterion<3, double> arrest(hit_threshold, 2, gas.box().clock_unit(), 0);
    while (const auto collision = gas.next_collision(7)) {
      EXPECT_NEAR(gas.time(), radius - 1 / std::sqrt(3.0), 1e-14);
      separation.observe(*collision);
      arrest.observe(*collision);
      ASSERT_LT(gas.collisions(), 20);
    }
    EXPECT_TRUE(gas.has_reached(7));  // they have flown apart
    EXPECT_GE(gas.collisions(), 3);
    EXPECT_NEAR(support::twice_energy(gas), 3, 1e-14);
    EXPECT_FALSE(arrest.is_met());
    if (separation.hits() > 0) ++met;
  }
  EXPECT_GE(met, triples / 4);
}

}  // namespace
}  // namespace zenosphere
