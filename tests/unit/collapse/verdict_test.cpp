#include "collapse/verdict.hpp"

#include <gtest/gtest.h>

namespace zenosphere {
namespace {

/// 1000 collisions of 100 spheres in a time of 10: a sphere flies for 10 / 20 = 1/2 between two of
/// its collisions, on average. Hits from collision 100 on, at time 1.
Course course(std::int64_t last_hit, double last_hit_time) {
  return {.collisions = 1000,
          .collisions_per_sphere = 20,
          .time = 10,
          .window = 500,
          .last_hit = last_hit,
          .last_hit_time = last_hit_time};
}

TEST(Verdict, IsNoneWithoutAHitAndTrueWithAnArrest) {
  Course run = course(900, 9);
  run.last_hit.reset();
  EXPECT_EQ(verdict(run), Verdict::none);
  run = course(100, 1);
  run.is_arrested = true;
  EXPECT_EQ(verdict(run), Verdict::arrested);
}

TEST(Verdict, IsTemporaryWhereTheClockHasGoneOnForMoreThanAFlightOfASphere) {
  EXPECT_EQ(verdict(course(990, 9.4)), Verdict::temporary);
  EXPECT_EQ(verdict(course(990, 9.6)), Verdict::open);
}

TEST(Verdict, IsOpenAsLongAsPausesAreNoLongerThanThoseBetweenHits) {
  Course run = course(990, 9.4);
  run.longest_pause = 0.5;
  EXPECT_EQ(verdict(run), Verdict::temporary);
  run.longest_pause = 0.7;
  EXPECT_EQ(verdict(run), Verdict::open);
}

TEST(Verdict, IsTemporaryAfterAWindowOfCollisionsThoughTheClockHasHardlyMoved) {
  EXPECT_EQ(verdict(course(499, 9.999)), Verdict::temporary);
  EXPECT_EQ(verdict(course(500, 9.999)), Verdict::open);
}

TEST(Verdict, OfAShortWindowNeedsACollisionOfEachSphereToo) {
  // 50 collisions are one of each of the 100 spheres.
  Course run = course(951, 9.999);
  run.window = 10;
  EXPECT_EQ(verdict(run), Verdict::open);
  run.last_hit = 950;
  EXPECT_EQ(verdict(run), Verdict::temporary);
}

TEST(Verdict, IsTemporaryWhereNothingCanHappenAnyMore) {
  Course run = course(999, 10);
  EXPECT_EQ(verdict(run), Verdict::open);
  run.is_at_rest = true;
  EXPECT_EQ(verdict(run), Verdict::temporary);
}

TEST(Verdict, ByTheWindowAloneIsThatOfOldFiles) {
  Course run = course(990, 1);
  run.last_hit_time.reset();
  EXPECT_EQ(verdict_by_window(run), Verdict::open);
  run.last_hit = 499;
  EXPECT_EQ(verdict_by_window(run), Verdict::temporary);
}

}  // namespace
}  // namespace zenosphere
