#include "collapse/approach.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zenosphere {
namespace {

constexpr double limit = 16;  // decades of double

/// Two pairs in turn, whose gaps fall by `rate` decades a collision from 1e-1 on.
std::vector<DepthRow> falling(int collisions, double rate) {
  std::vector<DepthRow> rows;
  for (int k = 0; k < collisions; ++k) {
    const double depth = std::min(1 + rate * k, limit);
    rows.push_back({k % 2, k % 2 + 1, depth, depth >= limit});
  }
  return rows;
}

TEST(Approaches, GapsThatFallSteadilyAreSpentByOneLaw) {
  const auto found = approaches_of(falling(200, 0.1), limit, least_approach_depth);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].is_spent);
  EXPECT_EQ(found[0].last, 150u);  // 1 + 0.1 x 150 = 16
  ASSERT_TRUE(found[0].steady);
  EXPECT_NEAR(found[0].steady->per_collision, 0.1, 0.005);
  EXPECT_GT(found[0].steady->decades, 10);
  EXPECT_FALSE(found[0].reopened_to);
}

TEST(Approaches, GapsThatGrowAgainAreReopened) {
  auto rows = falling(121, 0.1);  // down to 1e-13
  for (int k = 0; k < 120; ++k) rows.push_back({k % 2, k % 2 + 1, 13 - 0.1 * k, false});
  const auto found = approaches_of(rows, limit, least_approach_depth);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_FALSE(found[0].is_spent);
  EXPECT_NEAR(found[0].deepest, 13, 0.01);
  ASSERT_TRUE(found[0].reopened_to);
  EXPECT_LT(*found[0].reopened_to, 3);
}

TEST(Approaches, ReopeningIsToldUpToItsEnd) {
  auto rows = falling(121, 0.1);  // down to 1e-13, then up to 1e-8.4, and down to the limit
  for (int k = 0; k < 46; ++k) rows.push_back({k % 2, k % 2 + 1, 13 - 0.1 * k, false});
  for (int k = 0; k < 70; ++k) rows.push_back({k % 2, k % 2 + 1, 8.4 + 0.1 * k, false});
  const auto found = approaches_of(rows, limit, least_approach_depth);
  ASSERT_EQ(found.size(), 2u);
  ASSERT_TRUE(found[0].reopened_to);
  EXPECT_LE(*found[0].reopened_to, 13 - 4);  // a quarter of the 16 decades, at least
}

TEST(Approaches, StaircaseWithSmallStepsIsOneApproach) {
  std::vector<DepthRow> rows;
  for (int k = 0; k < 400; ++k) {
    const double depth = 1 + 0.03 * k + 1.5 * std::sin(k / 10.0);  // gives way by less than 4
    rows.push_back({k % 2, k % 2 + 1, depth, depth >= limit});
  }
  EXPECT_EQ(approaches_of(rows, limit, least_approach_depth).size(), 1u);
}

/// A fall to 1e-60, a step back by so many decades, and a fall to the limit of 1e-100.
std::vector<DepthRow> fall_with_a_step(double step) {
  std::vector<DepthRow> rows;
  for (int k = 0; k < 1500; ++k) {
    const double depth = k < 600   ? 0.1 * k
                         : k < 720 ? 60 - step * (k - 600) / 120
                                   : std::min(60 - step + 0.1 * (k - 720), 100.0);
    rows.push_back({k % 2, k % 2 + 1, depth, depth >= 100});
  }
  return rows;
}

TEST(Approaches, StepBackByLessThanAFifthOfTheDepthBelongsToADeepFall) {
  EXPECT_EQ(approaches_of(fall_with_a_step(11), 100, least_approach_depth).size(), 1u);
  EXPECT_EQ(approaches_of(fall_with_a_step(14), 100, least_approach_depth).size(), 2u);
}

TEST(Approaches, GapsOfAGasAreNone) {
  std::vector<DepthRow> rows;
  for (int k = 0; k < 400; ++k) rows.push_back({k % 2, k % 2 + 1, 1.0 + k % 5, false});
  EXPECT_TRUE(approaches_of(rows, limit, least_approach_depth).empty());
}

TEST(Approaches, GapsThatJumpToTheLimitVisitNothingBetween) {
  std::vector<DepthRow> rows = falling(20, 0.01);
  for (int k = 0; k < 40; ++k) rows.push_back({k % 2, k % 2 + 1, limit, true});
  const auto found = approaches_of(rows, limit, least_approach_depth);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].is_spent);
  EXPECT_EQ(found[0].visited, 0);
}

TEST(DeepClusters, ConnectWhoMeetsThriceAtSmallGaps) {
  std::vector<DepthRow> rows;
  for (int k = 0; k < 3; ++k) rows.push_back({0, 1, 9, false});
  for (int k = 0; k < 3; ++k) rows.push_back({1, 2, 9, false});
  for (int k = 0; k < 2; ++k) rows.push_back({2, 3, 9, false});  // once or twice is chance
  for (int k = 0; k < 9; ++k) rows.push_back({4, 5, 7, false});  // not deep
  const auto clusters = deep_clusters(rows, least_approach_depth, 6);
  ASSERT_EQ(clusters.size(), 1u);
  EXPECT_EQ(clusters[0], (std::vector<std::int32_t>{0, 1, 2}));
}

TEST(DeepClusters, AreNotConnectedByAWall) {
  std::vector<DepthRow> rows;
  for (int k = 0; k < 3; ++k) rows.push_back({0, 2, 9, false});  // 2: the lower wall of two balls
  for (int k = 0; k < 3; ++k) rows.push_back({1, 2, 9, false});
  EXPECT_EQ(deep_clusters(rows, least_approach_depth, 2).size(), 2u);
}

}  // namespace
}  // namespace zenosphere
