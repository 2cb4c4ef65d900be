#include "report/frequent_pairs.hpp"

#include <gtest/gtest.h>

namespace zenosphere {
namespace {

CollisionRow row(std::int32_t i, std::int32_t j, std::uint8_t flags = 0) {
  return {.k = 1, .time = 0, .i = i, .j = j, .gap = 1, .normal_speed = 1, .flags = flags};
}

TEST(FrequentPairs, AreCountedExactlyWhileThereIsACounterForEach) {
  FrequentPairs pairs;
  for (int n = 0; n < 3; ++n) pairs.observe(row(7, 9));
  for (int n = 0; n < 5; ++n) pairs.observe(row(2, 4000000));
  pairs.observe(row(3, 8));
  pairs.observe(row(1, 8));
  EXPECT_EQ(pairs.most_frequent(3),
            (std::vector<PairCount>{{2, 4000000, 5}, {7, 9, 3}, {1, 8, 1}}));
  EXPECT_EQ(pairs.most_frequent(9).size(), 4U);
}

TEST(FrequentPairs, PairWithMoreThanItsShareOfTheLogIsFoundWithFewCounters) {
  FrequentPairs pairs(4);  // a pair with more than a quarter of the 900 rows cannot be lost
  for (int n = 0; n < 300; ++n) {
    pairs.observe(row(1, 2));
    pairs.observe(row(3, 100 + n));
    pairs.observe(row(4, 500 + n));
  }
  const auto found = pairs.most_frequent(1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].i, 1);
  EXPECT_EQ(found[0].j, 2);
  EXPECT_GE(found[0].collisions, 300 - 900 / 4);
  EXPECT_LE(found[0].collisions, 300);
}

TEST(PairRaster, TellsForEachBinWhichPairsCollideAndHitInIt) {
  PairRaster raster({{1, 2, 50}, {3, 4, 40}}, 3);
  raster.observe(row(1, 2));
  raster.observe(row(1, 2, collision_flag::hit));
  raster.observe(row(8, 9));
  raster.observe(row(3, 4));
  raster.observe(row(5, 6, collision_flag::hit));
  EXPECT_EQ(raster.pairs(), (std::vector<PairCount>{{1, 2, 2}, {3, 4, 1}}));
  const std::int32_t others = 1 << 10, hit = 1 << 11, others_hit = 1 << 21;
  EXPECT_EQ(raster.bins(), (std::vector<std::int32_t>{1 | hit | others, 2 | others | others_hit}));
}

}  // namespace
}  // namespace zenosphere
