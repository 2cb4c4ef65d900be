#include "report/frames.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace zenosphere {
namespace {

/// Two disks in a box of side 4, at y = 1 and 3.
Snapshot two_disks(std::int64_t step, std::vector<double> velocities) {
  return {.step = step,
          .time = 0.1 * static_cast<double>(step),
          .positions = {0.5, 1, 2.5, 3},
          .velocities = std::move(velocities),
          .box_edges = {4, 0, 0, 4}};
}

TEST(SpreadSnapshots, TakesTheFirstAndTheLast) {
  EXPECT_EQ(spread_snapshots(5, 100), (std::vector<std::int64_t>{0, 1, 2, 3, 4}));
  EXPECT_EQ(spread_snapshots(101, 3), (std::vector<std::int64_t>{0, 50, 100}));
  EXPECT_EQ(spread_snapshots(9, 0), (std::vector<std::int64_t>{0, 8}));
  EXPECT_EQ(spread_snapshots(1, 7), (std::vector<std::int64_t>{0}));
  EXPECT_TRUE(spread_snapshots(0, 7).empty());
}

TEST(FrameCollector, LeavesTheMeanFlowOutOfSpeedAndTemperature) {
  FrameCollector collector(2, 2, {}, 0.5, {0});
  // At y - 2 = -1 and 1 the flow is -0.5 and 0.5; on top of it (0.3, 0.4) and (0, 0).
  collector.observe(two_disks(0, {-0.2, 0.4, 0.5, 0}));
  const Frames frames = std::move(collector).result(true);
  EXPECT_NEAR(frames.speeds[0], 0.5F, 1e-7);  // float
  EXPECT_EQ(frames.speeds[1], 0.0F);
  EXPECT_NEAR(frames.granular_temperature[0], 0.25 / 4, 1e-16);  // some ulps of 0.06
}

TEST(FrameCollector, WeighsTheTemperatureByMassAndLeavesOutWhatIsImmobile) {
  const std::vector<double> velocities{3, 4, 1, 0};
  Grains<double> grains;
  grains.masses = {2, 5};
  FrameCollector both(2, 2, grains, 0, {0});
  both.observe(two_disks(0, velocities));
  EXPECT_EQ(std::move(both).result(true).granular_temperature[0], (2 * 25 + 5 * 1) / 4.0);
  grains.immobile = {0, 1};
  FrameCollector one(2, 2, grains, 0, {0});
  one.observe(two_disks(0, velocities));
  EXPECT_EQ(std::move(one).result(true).granular_temperature[0], 2 * 25 / 2.0);
}

TEST(FrameCollector, CountsTheCollisionsOfSpheresAndNotOfWalls) {
  FrameCollector collector(2, 2, {}, 0, {0, 2});
  collector.observe(two_disks(0, {0, 0, 0, 0}));
  collector.observe({.k = 1, .i = 0, .j = 1});
  collector.observe(two_disks(1, {0, 0, 0, 0}));
  collector.observe({.k = 2, .i = 1, .j = 2});  // the lower wall
  collector.observe(two_disks(2, {0, 0, 0, 0}));
  const Frames frames = std::move(collector).result(true);
  EXPECT_EQ(frames.step, (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(frames.collisions, (std::vector<std::int32_t>{0, 0, 1, 2}));
  EXPECT_EQ(frames.positions.size(), 8U);
}

TEST(FrameCollector, TellsNoCountsWhereTheLogHasGaps) {
  FrameCollector collector(2, 2, {}, 0, {0});
  collector.observe(two_disks(0, {0, 0, 0, 0}));
  EXPECT_TRUE(std::move(collector).result(false).collisions.empty());
}

}  // namespace
}  // namespace zenosphere
