#include "model/clock.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace zenosphere {
namespace {

TEST(Clock, ElapsedCountsUnitsAndRemainders) {
  // From 3 units + 0.25 to 5 units + 0.125, a unit being 0.5: 2 x 0.5 - 0.125 = 0.875.
  EXPECT_EQ(elapsed<double>({3, 0.25}, {5, 0.125}, 0.5), 0.875);
  EXPECT_EQ(elapsed<double>({5, 0.125}, {3, 0.25}, 0.5), -0.875);
}

TEST(Clock, StandsStillOnlyIfNoBitMoved) {
  const Instant<double> instant{7, 0.5};
  EXPECT_EQ(elapsed(instant, instant, 1.0), 0);
  EXPECT_EQ(elapsed<double>({7, 0.5}, {7, 0.5 + 0x1p-53}, 1.0), 0x1p-53);
}

TEST(Clock, ResolutionDoesNotDecayWithTheLengthOfTheRun) {
  // As one number near 1e12 the clock could not resolve less than 1.2e-4.
  const Instant<double> earlier{1000000000000, 0.5};
  const Instant<double> later{1000000000000, 0.5 + 1e-15};
  EXPECT_NEAR(elapsed(earlier, later, 1.0), 1e-15, 0x1p-53);
}

TEST(Clock, SinceStartIsOneNumber) {
  EXPECT_EQ(since_start<double>({4, 0.25}, 0.5), 2.25);
  EXPECT_EQ(since_start<double>({}, 0.5), 0);
}

TEST(Clock, HasAnInstantForEveryTime) {
  const auto units_at = [](double time) { return instant_at(time, 0.5).units; };
  EXPECT_EQ(units_at(2.25), 4);
  EXPECT_EQ(instant_at(2.25, 0.5).remainder, 0.25);
  EXPECT_EQ(units_at(1e300), 2e300);
  EXPECT_EQ(units_at(std::numeric_limits<double>::infinity()), most_units);
  EXPECT_EQ(units_at(std::numeric_limits<double>::quiet_NaN()), most_units);
  EXPECT_EQ(units_at(-0.25), -1);  // an overlap in a forged state leads that far back, or farther
  EXPECT_EQ(units_at(-1e300), -1);
}

TEST(Clock, CountsInStridesThatKeepItExact) {
  EXPECT_EQ(least_stride(0), 1);
  EXPECT_EQ(least_stride(0x1p52 - 1), 1);
  EXPECT_EQ(least_stride(0x1p52), 2);
  EXPECT_EQ(least_stride(most_units), 0x1p972);
  // 21 units of 0.5 are five strides of four and one unit.
  const Instant<double> instant = instant_at(10.625, 0.5, 4);
  EXPECT_EQ(instant.units, 20);
  EXPECT_EQ(instant.remainder, 0.625);
}

}  // namespace
}  // namespace zenosphere
