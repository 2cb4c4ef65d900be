#include "collapse/collapse_time.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace zenosphere {
namespace {

/// Shows the observer collisions that come one flight after another, from time 0 on.
CollapseTime<1, double> after_flights(const std::vector<double>& flights, double clock_unit = 1) {
  CollapseTime<1, double> observer(clock_unit);
  Collision<1, double> collision;
  for (const double flight : flights) {
    ++collision.number;
    collision.flight = flight;
    collision.time.remainder += flight;
    observer.observe(collision);
  }
  return observer;
}

TEST(CollapseTime, OfHalvedFlightsIsTheSumOfTheSeries) {
  // 1 + 1/2 + ... = 2; six flights make five ratios, the first of which has four like it.
  const auto observer = after_flights({1, 0.5, 0.25, 0.125, 0.0625, 0.03125});
  EXPECT_DOUBLE_EQ(observer.time().value(), 2);
  EXPECT_DOUBLE_EQ(observer.ratio().value(), 0.5);
}

TEST(CollapseTime, IsNotReadFromFlightsThatAreRoundingWhereTheClockStands) {
  // At 2^40 in a stride as long the last place is 2^-12: flights below 24 are rounding.
  CollapseTime<1, double> observer(1);
  Collision<1, double> collision;
  collision.time.remainder = 0x1p40;
  for (const double flight : {16.0, 8.0, 4.0, 2.0, 1.0, 0.5, 0.25}) {
    collision.flight = flight;
    collision.time.remainder += flight;
    observer.observe(collision);
  }
  EXPECT_FALSE(observer.time());
}

TEST(CollapseTime, NeedsSixFlights) {
  const auto observer = after_flights({1, 0.5, 0.25, 0.125, 0.0625});
  EXPECT_FALSE(observer.time());
  EXPECT_FALSE(observer.ratio());
}

TEST(CollapseTime, DoesNotExistForEqualOrGrowingFlights) {
  EXPECT_FALSE(after_flights({1, 1, 1, 1, 1, 1, 1, 1}).time());
  EXPECT_FALSE(after_flights({1, 2, 4, 8, 16, 32, 64}).time());
}

TEST(CollapseTime, DoesNotExistForRatiosThatDifferByMoreThanAThousandth) {
  // The ratio is 0.5 and 0.502 in turn.
  EXPECT_FALSE(after_flights({1, 0.5, 0.251, 0.1255, 0.063001, 0.0315005, 0.015813251}).time());
}

TEST(CollapseTime, IsNotReadFromFlightsThatAreZeroOrNegative) {
  EXPECT_FALSE(after_flights({0, 0, 0, 0, 0, 0, 0}).time());
  EXPECT_FALSE(after_flights({-1, -0.5, -0.25, -0.125, -0.0625, -0.03125}).time());
}

TEST(CollapseTime, OutlivesTheSeriesItWasReadFrom) {
  // Once the clock stands still the flights are zero; the estimate stays.
  const auto observer = after_flights({1, 0.5, 0.25, 0.125, 0.0625, 0.03125, 0, 0});
  EXPECT_DOUBLE_EQ(observer.time().value(), 2);
}

TEST(CollapseTime, StartsAnewAfterAFlightThatDoesNotFit) {
  // Five flights of 8 x 4^-k after the long one: too few; with the sixth the end is at
  // 1.9375 + 8/(1 - 1/4).
  std::vector<double> flights{1, 0.5, 0.25, 0.125, 0.0625, 8, 2, 0.5, 0.125, 0.03125};
  EXPECT_FALSE(after_flights(flights).time());
  flights.push_back(0.0078125);
  EXPECT_DOUBLE_EQ(after_flights(flights).time().value(), 1.9375 + 8 / 0.75);
  EXPECT_DOUBLE_EQ(after_flights(flights).ratio().value(), 0.25);
}

TEST(CollapseTime, IsCountedFromTheStartInWholeClockUnits) {
  // The last collision comes at 3 units of 0.5 and 0.25 = 1.75; 1/32 x 1 = 1/32 is still to come.
  CollapseTime<1, double> observer(0.5);
  Collision<1, double> collision;
  for (const double flight : {1.0, 0.5, 0.25, 0.125, 0.0625, 0.03125}) {
    collision.flight = flight;
    collision.time = {3, 0.25};
    observer.observe(collision);
  }
  EXPECT_DOUBLE_EQ(observer.time().value(), 1.75 + 0.03125);
}

}  // namespace
}  // namespace zenosphere
