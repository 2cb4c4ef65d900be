#include "verify/replay.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zenosphere::verify {
namespace {

/// Two disks in a box of 10 x 8, restitution 1/2.
Case planar_case() {
  Case values;
  values.system = {.dimension = 2, .spheres = 2, .restitution = 0.5, .sides = {10, 8}};
  return values;
}

// Disks at (1, 1) and (4, 1), the first with speed 1 along x: they touch at time 2, after which the
// speeds are (1 - e)/2 = 1/4 and (1 + e)/2 = 3/4. At time 3 they are at 3 + 1/4
// and 4 + 3/4.
const Snapshot begin{0, 0, {1, 1, 4, 1}, {1, 0, 0, 0}, {10, 0, 0, 8}};
const CollisionRow touch{1, 2, 0, 1, 0, 1, 0};
const Snapshot end{1, 3, {3.25, 1, 4.75, 1}, {0.25, 0, 0.75, 0}, {10, 0, 0, 8}};

std::int64_t contradictions(const Snapshot& first, const CollisionRow& row, const Snapshot& last,
                            const Case& values = planar_case()) {
  Replay<2> replay(values, 2);
  Findings findings;
  replay.observe(first, findings);
  replay.observe(row, findings);
  replay.observe(last, findings);
  EXPECT_EQ(replay.coverage().snapshots, 1);
  return findings.count();
}

TEST(Replay, FollowsACollisionThatIsRight) { EXPECT_EQ(contradictions(begin, touch, end), 0); }

// The engine may follow both in the frame of their mean velocity, 2^29, in which the one at rest
// flies too: 2^30 diameters until the end, whose last place is 2^-22; snapshots themselves are
// stored to 1e-15.
TEST(Replay, AllowsWhatTheFrameOfAllRoundsInASphereThatRests) {
  Replay<2> replay(planar_case(), 2);
  Findings findings;
  replay.observe({0, 0, {1, 1, 4, 5}, {0x1p30, 0, 0, 0}, {10, 0, 0, 8}}, findings);
  const double way = std::fmod(0x1p31, 10.0);
  replay.observe({0, 2, {1 + way, 1, 4 + 0x1p-24, 5}, {0x1p30, 0, 0, 0}, {10, 0, 0, 8}}, findings);
  EXPECT_EQ(findings.count(), 0);
  replay.observe({0, 4, {7, 1, 4.01, 5}, {0x1p30, 0, 0, 0}, {10, 0, 0, 8}}, findings);
  EXPECT_GT(findings.count(), 0);
}

// They stick: at the time 1e30 their places are known to 1e14 only, and which image touches is not.
TEST(Replay, SaysNothingOfAGapToAnUnknownImage) {
  Case sticky = planar_case();
  sticky.system.restitution = 0;
  Replay<2> replay(sticky, 2);
  Findings findings;
  CollisionRow first = touch;
  first.gap = 8;  // around the box
  replay.observe(begin, findings);
  replay.observe(first, findings);
  replay.observe({2, 1e30, 0, 1, 0, 1e-30, 0}, findings);
  EXPECT_EQ(findings.count(), 0);
}

TEST(Replay, FindsAnotherTimePairSpeedOrRestitution) {
  CollisionRow row = touch;
  row.time += 1e-12;
  EXPECT_GT(contradictions(begin, row, end), 0);
  row = touch;
  row.normal_speed -= 1e-12;
  EXPECT_GT(contradictions(begin, row, end), 0);
  Case softer = planar_case();
  softer.system.restitution = 0.4999999;
  EXPECT_GT(contradictions(begin, touch, end, softer), 0);
}

TEST(Replay, FindsASphereElsewhereOrWithAnotherVelocity) {
  Snapshot moved = end;
  moved.positions[3] += 1e-12;
  EXPECT_EQ(contradictions(begin, touch, moved), 1);
  Snapshot faster = end;
  faster.velocities[1] += 1e-12;
  EXPECT_EQ(contradictions(begin, touch, faster), 1);
}

TEST(Replay, MeetsTheImageBeyondASlidingFace) {
  // Shear rate 1/4: the upper image of the box moves at 2 along x and is 2 ahead at time 1. The
  // disk at (1, 0.25) is seen from above at (3 + 1, 8.25), where the other is at (4, 7.25).
  Case values = planar_case();
  values.drive = {.kind = DriveKind::shear, .shear_rate = 0.25};
  const Snapshot first{0, 0, {1, 0.25, 4, 6.25}, {1, 0, 0, 1}, {10, 0, 0, 8}};
  // Image of the first: at (2 + 2, 8.25) with velocity (1 + 2, 0); normal (0, -1) from it to the
  // second, closing speed 1, impulse 3/4 each.
  const CollisionRow row{1, 1, 0, 1, 0, 1, 0};
  const Snapshot last{1, 1.5, {2.5, 0.625, 4, 7.375}, {1, 0.75, 0, 0.25}, {10, 0, 3, 8}};
  EXPECT_EQ(contradictions(first, row, last, values), 0);
}

/// What is said of the gap in the first of two rows.
std::int64_t contradictions_of_gap(double gap, const Snapshot& first, CollisionRow one,
                                   const CollisionRow& two, const Case& values,
                                   std::int64_t criteria_version) {
  one.gap = gap;
  Replay<2> replay(values, 2, criteria_version);
  Findings findings;
  replay.observe(first, findings);
  replay.observe(one, findings);
  replay.observe(two, findings);
  EXPECT_EQ(replay.coverage().replayed, 2);
  return findings.count();
}

TEST(Replay, FindsTheGapToTheImageThatMeetsAndInOldFilesToTheNearest) {
  // After `touch` the speeds are 1/4 and 3/4; the image of the second behind the first is 10 - 1
  // from it, 8 to close at a speed of 1/2: at time 2 + 16. In the nearest image they touch.
  const CollisionRow again{2, 18, 0, 1, 0, 0.5, 0};
  const Case values = planar_case();
  EXPECT_EQ(contradictions_of_gap(8, begin, touch, again, values, 2), 0);
  EXPECT_EQ(contradictions_of_gap(0, begin, touch, again, values, 2), 1);
  EXPECT_EQ(contradictions_of_gap(0, begin, touch, again, values, 1), 0);
  EXPECT_EQ(contradictions_of_gap(8, begin, touch, again, values, 1), 1);
}

TEST(Replay, FindsTheApexOfABallBetweenTwoBouncesAndInOldFilesTheFloor) {
  // A disk half a diameter up lands at 1 with 1, leaves with 1/2, rises by 1/8, and lands at 2.
  Case values = planar_case();
  values.walls = {.axis = Axis::y, .restitution = 0.5};
  values.gravity.acceleration = {0, -1};
  const Snapshot first{0, 0, {1, 1, 5, 7}, {0, 0, 0, 0}, {10, 0, 0, 8}};
  const CollisionRow landing{1, 1, 0, 2, 0, 1, 0};
  const CollisionRow second{2, 2, 0, 2, 0, 0.5, 0};
  EXPECT_EQ(contradictions_of_gap(0.125, first, landing, second, values, 2), 0);
  EXPECT_EQ(contradictions_of_gap(0, first, landing, second, values, 2), 1);
  EXPECT_EQ(contradictions_of_gap(0, first, landing, second, values, 1), 0);
}

TEST(Replay, OfARowWithoutTheOneBeforeIsNotTried) {
  const Case values = planar_case();
  Replay<2> replay(values, 2);
  Findings findings;
  replay.observe(begin, findings);
  CollisionRow row = touch;
  row.k = 2;
  replay.observe(row, findings);
  EXPECT_EQ(replay.coverage().unreached, 1);
  EXPECT_EQ(replay.coverage().replayed, 0);
}

}  // namespace
}  // namespace zenosphere::verify
