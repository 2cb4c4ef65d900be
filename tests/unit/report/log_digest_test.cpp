#include "report/log_digest.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace zenosphere {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

CollisionRow logged(std::int64_t k, double gap, double speed, std::uint8_t flags = 0) {
  return {.k = k,
          .time = 0.5 * static_cast<double>(k),
          .i = 1,
          .j = 2,
          .gap = gap,
          .normal_speed = speed,
          .flags = flags};
}

TEST(LogDigest, ShortLogIsKeptRowByRow) {
  LogDigest digest(3);
  digest.observe(logged(1, 1e-3, 0.5));
  digest.observe(logged(2, -1e-16, 0.25, collision_flag::hit));
  digest.observe(logged(3, unknown, 0.125));
  const LogStretch& all = digest.stretch();
  EXPECT_EQ(all.width, 1);
  EXPECT_EQ(all.last, 3);
  EXPECT_EQ(all.k, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(all.gap_low[1], -1e-16);
  EXPECT_TRUE(std::isnan(all.gap_low[2]));
  EXPECT_EQ(all.i, (std::vector<std::int32_t>{1, 1, 1}));
  EXPECT_EQ(all.flags[1], collision_flag::hit);
}

TEST(LogDigest, LongLogKeepsEveryExtremeAndCountsEveryHit) {
  const std::int64_t rows = LogDigest::most_rows + 1;  // bins of 3 rows: 65537 / 32768, upwards
  LogDigest digest(rows);
  for (std::int64_t k = 1; k <= rows; ++k) {
    const double gap = k == 40000 ? 1e-17 : k == 50000 ? 7.0 : k == 60000 ? unknown : 1e-3;
    const double speed = k == 30000 ? 1e-15 : k == 30001 ? 99.0 : 1.0;
    CollisionRow next = logged(k, gap, speed, k == 40000 ? collision_flag::hit : std::uint8_t{0});
    if (k == 45000) next.time -= 0.5;  // the clock stands still, and then leaps
    digest.observe(next);
  }
  const LogStretch& all = digest.stretch();
  EXPECT_EQ(all.width, 3);
  EXPECT_EQ(all.bins(), 21846U);  // 65537 / 3, upwards
  EXPECT_EQ(all.last, rows);
  EXPECT_EQ(std::ranges::min(all.gap_low), 1e-17);
  EXPECT_EQ(std::ranges::max(all.gap_high), 7.0);
  EXPECT_EQ(std::ranges::min(all.speed_low), 1e-15);
  EXPECT_EQ(std::ranges::max(all.speed_high), 99.0);
  EXPECT_EQ(std::ranges::min(all.flight_low), 0.0);
  EXPECT_EQ(std::ranges::max(all.flight_high), 1.0);
  EXPECT_EQ(std::accumulate(all.hits.begin(), all.hits.end(), 0), 1);
  // 40000 = 3 x 13333 + 1 is the first row of its bin.
  EXPECT_EQ(all.flags[13333], collision_flag::hit);
  EXPECT_EQ(all.time.back(), 0.5 * static_cast<double>(rows));
  EXPECT_TRUE(all.i.empty());
}

TEST(LogDigest, UnknownGapDoesNotHideAKnownOneInItsBin) {
  const std::int64_t rows = LogDigest::most_rows + 1;
  LogDigest digest(rows);
  digest.observe(logged(1, unknown, 1));
  digest.observe(logged(2, 1e-9, 1));
  EXPECT_EQ(digest.stretch().gap_low.front(), 1e-9);
  EXPECT_EQ(digest.stretch().gap_high.front(), 1e-9);
}

TEST(CloseUp, KeepsTheRowsAboutOneCollision) {
  CloseUp close_up(100'000);
  for (std::int64_t k = 1; k <= 200'000; ++k) close_up.observe(logged(k, 1e-3, 1));
  const LogStretch& kept = close_up.stretch();
  EXPECT_EQ(kept.width, 1);
  EXPECT_EQ(kept.bins(), 4096U);
  EXPECT_EQ(kept.k.front(), 100'000 - 2048);
  EXPECT_EQ(kept.last, 100'000 + 2047);
}

}  // namespace
}  // namespace zenosphere
