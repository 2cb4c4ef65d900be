#include "collapse/separation_criterion.hpp"

#include <gtest/gtest.h>

#include "support/records.hpp"

namespace zenosphere {
namespace {

using support::record;
using Separation = SeparationCriterion<3, double>;

TEST(SeparationCriterion, IsMetAtTheCollisionBeforeTheOneThatWasSoClose) {
  // After collision 2, at time 0.2, the pair that collides next is 5e-17 apart.
  Separation criterion(1e-16, 1.0);
  criterion.observe(record(1, 0, 1, 0.5, 0.1));
  criterion.observe(record(2, 1, 2, 0.5, 0.2));
  EXPECT_FALSE(criterion.first_collision());
  EXPECT_FALSE(criterion.first_time());
  criterion.observe(record(3, 0, 1, 5e-17, 0.3));
  EXPECT_EQ(criterion.hits(), 1);
  EXPECT_EQ(criterion.first_collision(), 2);
  EXPECT_EQ(criterion.first_time(), 0.2);
  EXPECT_EQ(criterion.last_collision(), 2);
}

TEST(SeparationCriterion, IsNotMetBeforeTheFirstCollision) {
  Separation criterion(1e-16, 1.0);
  criterion.observe_next(0);  // where the run ends at a pair that touches
  EXPECT_EQ(criterion.hits(), 0);
  criterion.observe(record(1, 0, 1, 0, 0));
  EXPECT_EQ(criterion.hits(), 0);
}

TEST(SeparationCriterion, TakesTheThresholdZeroAndOverlapsAsHits) {
  Separation criterion(1e-16, 1.0);
  criterion.observe(record(1, 0, 1, 1, 0.1));
  criterion.observe(record(2, 0, 1, 1e-16, 0.2));
  criterion.observe(record(3, 0, 1, 0, 0.3));
  criterion.observe(record(4, 0, 1, -3e-16, 0.4));
  EXPECT_EQ(criterion.hits(), 3);
  criterion.observe(record(5, 0, 1, 1.01e-16, 0.5));
  EXPECT_EQ(criterion.hits(), 3);
}

TEST(SeparationCriterion, KeepsTheFirstHitAndFollowsTheLast) {
  Separation criterion(1e-16, 1.0);
  criterion.observe(record(1, 0, 1, 1, 0.125));
  criterion.observe(record(2, 0, 1, 0, 0.25));
  criterion.observe(record(3, 0, 1, 1, 0.5));
  criterion.observe(record(4, 0, 1, 0, 0.75));
  criterion.observe(record(5, 0, 1, 1, 0.875));
  EXPECT_EQ(criterion.hits(), 2);
  EXPECT_EQ(criterion.first_collision(), 1);
  EXPECT_EQ(criterion.first_time(), 0.125);
  EXPECT_EQ(criterion.last_collision(), 3);
}

TEST(SeparationCriterion, KeepsTheTimeOfTheLastHitAndTheLongestPauseBetweenTwo) {
  Separation criterion(1e-16, 1.0);
  EXPECT_FALSE(criterion.last_time());
  criterion.observe(record(1, 0, 1, 1, 0.125));
  criterion.observe(record(2, 0, 1, 0, 0.25));  // hit at 0.125
  EXPECT_EQ(criterion.result().longest_pause, 0);
  criterion.observe(record(3, 0, 1, 1, 0.5));
  criterion.observe(record(4, 0, 1, 0, 0.75));    // at 0.5, 0.375 later
  criterion.observe(record(5, 0, 1, 0, 0.6875));  // at 0.75, 0.25 later
  criterion.observe(record(6, 0, 1, 0, 1));       // at 0.6875: the clock was set back
  EXPECT_EQ(criterion.result().longest_pause, 0.375);
  EXPECT_EQ(criterion.last_time(), 0.6875);
}

TEST(SeparationCriterion, DoesNotCountAStartInContact) {
  // Before collision 1 there is no collision after which a pair could be close.
  Separation criterion(1e-16, 1.0);
  criterion.observe(record(1, 0, 1, 0, 0.1));
  EXPECT_EQ(criterion.hits(), 0);
}

TEST(SeparationCriterion, TellsTheTimeAcrossClockUnits) {
  // Unit 0.5: collision 1 at 3 units + 0.25 = 1.75.
  Separation criterion(1e-16, 0.5);
  auto collision = record(1, 0, 1, 1, 0.25);
  collision.time.units = 3;
  criterion.observe(collision);
  collision = record(2, 0, 1, 0, 0);
  collision.time.units = 4;
  criterion.observe(collision);
  EXPECT_EQ(criterion.first_time(), 1.75);
}

}  // namespace
}  // namespace zenosphere
