#include "model/walls.hpp"

#include <gtest/gtest.h>

namespace zenosphere {
namespace {

/// In double; the plain call would need the template argument each time.
std::optional<double> closing(double gap, double rate, double acceleration) {
  return closing_time<double>(gap, rate, acceleration);
}

TEST(ClosingTime, WithoutAccelerationIsTheGapOverItsRate) {
  EXPECT_EQ(closing(3, -2, 0), 1.5);
  EXPECT_EQ(closing(0, -2, 0), 0);
  EXPECT_EQ(closing(-1, -2, 0), -0.5);  // was zero half a time unit ago
}

TEST(ClosingTime, DoesNotExistWhereTheGapRestsOrOpensForGood) {
  EXPECT_FALSE(closing(3, 0, 0));
  EXPECT_FALSE(closing(3, 2, 0));
  EXPECT_FALSE(closing(-1, 2, 0));
  EXPECT_FALSE(closing(3, 2, 1));
  EXPECT_FALSE(closing(3, 0, 1));
  EXPECT_FALSE(closing(0, 2, 1));
}

TEST(ClosingTime, OfAnAcceleratedApproachIsTheEarlierRoot) {
  EXPECT_EQ(closing(1.5, -1, -1), 1);  // 1.5 - 1 - 1/2 = 0; the other root is -3
  EXPECT_EQ(closing(1.5, -2, 1), 1);   // 1.5 - 2 + 1/2 = 0; the other root is 3
  EXPECT_EQ(closing(2, -2, 1), 2);     // touches as it turns: 2 - 4 + 2 = 0 twice
}

TEST(ClosingTime, DoesNotExistWhereTheGapTurnsBackBeforeItIsClosed) {
  EXPECT_FALSE(closing(3, -2, 1));  // least gap 3 - 4 + 2 = 1, at time 2
}

TEST(ClosingTime, OfAGapThatOpensAndFallsBackIsTheLaterRoot) {
  EXPECT_EQ(closing(1.5, 1, -1), 3);  // 1.5 + 3 - 9/2 = 0; the other root is -1
  EXPECT_EQ(closing(0, 2, -4), 1);    // a ball that leaves the floor at 2: 2 v/G
  EXPECT_EQ(closing(2, 0, -1), 2);    // let go at height 2
}

TEST(ClosingTime, OfAnOverlapThatGrowsIsInThePast) {
  EXPECT_EQ(closing(-2.5, -2, 1), -1);   // -2.5 + 2 + 1/2 = 0
  EXPECT_EQ(closing(-1.5, -2, -1), -1);  // -1.5 + 2 - 1/2 = 0
}

TEST(ClosingTime, OfAnOverlapThatGrowsAndNeverWasAGapIsNotInTheFuture) {
  // The largest gap of this parabola was -1e-17 + (1e-10)^2/2 < 0: a ball pressed into the floor by
  // rounding, slower than sqrt(2 x 1e-17) = 4.5e-9. Without a time it would fall through.
  const auto slow = closing(-1e-17, -1e-10, -1);
  ASSERT_TRUE(slow);
  EXPECT_LE(*slow, 0);
}

TEST(ClosingTime, OfAnOverlapThatOpensIsWhenItClosesAgain) {
  EXPECT_EQ(closing(-1.5, 2, -1), 3);  // -1.5 + 6 - 9/2 = 0; it opened at time 1
}

TEST(ClosingTime, OfAnOverlapThatOpensTooSlowlyIsWhenItShrinks) {
  EXPECT_EQ(closing(-1.5, 1, -1), 1);  // at most -1.5 + 1 - 1/2 = -1, at time 1
}

TEST(WidestGap, IsTheHeightOfTheApexWhereTheGapOpensAndFallsBack) {
  EXPECT_EQ(widest_gap<double>(0, 2, -4), 0.5);     // v^2 / (2 G)
  EXPECT_EQ(widest_gap<double>(1.5, 1, -1), 2);     // from where it is
  EXPECT_EQ(widest_gap<double>(1.5, -1, -1), 1.5);  // falls already
  EXPECT_EQ(widest_gap<double>(1.5, -1, 0), 1.5);
}

TEST(ClosingTime, KeepsTheDigitsOfATinyGap) {
  // To first order gap / speed; the next term is smaller by 1e-17. The textbook root
  // (1 - sqrt(1 -+ 2e-17)) would be 0.
  EXPECT_NEAR(closing(1e-17, -1, 1).value(), 1e-17, 1e-32);
  EXPECT_NEAR(closing(1e-17, -1, -1).value(), 1e-17, 1e-32);
  EXPECT_NEAR(closing(-1e-17, -1, 1).value(), -1e-17, 1e-32);
  // A fast flight in a weak field: t = gap/speed = 1e-3, and a t^2/2 = 5e-10 more to go at 1e3.
  EXPECT_NEAR(closing(1, -1e3, 1e-3).value(), 1e-3 + 5e-13, 1e-18);
}

}  // namespace
}  // namespace zenosphere
