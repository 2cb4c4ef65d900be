#include "engine/stride_clock.hpp"

#include <gtest/gtest.h>

namespace zenosphere {
namespace {

TEST(StrideClock, CountsFromLaterUnitsAfterAShift) {
  StrideClock<double> clock(0.5);
  clock.set_to(1.25);  // two units and a half
  EXPECT_EQ(clock.shift(2), 1);
  EXPECT_EQ(clock.now().units, 2);
  EXPECT_EQ(clock.remainder(), 0.25);
  EXPECT_TRUE(clock.has_reached(1.25));
  EXPECT_FALSE(clock.has_reached(1.2500001));
}

TEST(StrideClock, StaysWhereAnEventIsSlightlyInThePastUnlessItIsSetThere) {
  StrideClock<double> clock(1);
  clock.advance_to(0.5);
  clock.advance_to(0.5 - 0x1p-53);
  EXPECT_EQ(clock.remainder(), 0.5);
  clock.set_to(0.5 - 0x1p-53);
  EXPECT_EQ(clock.remainder(), 0.5 - 0x1p-53);
}

TEST(StrideClock, TellsEarlierInstantsByTheRemainderThatTheyHadFromNowOn) {
  StrideClock<double> clock(0.25, {{8, 0.125}, 1});
  EXPECT_EQ(clock.remainder_at({6, 0.0625}), 0.0625 - 2 * 0.25);
  EXPECT_EQ(clock.since({6, 0.0625}), 2 * 0.25 + 0.0625);
}

TEST(StrideClock, CountsInStrides) {
  StrideClock<double> clock(0.5);
  EXPECT_EQ(clock.span(), 0.5);
  clock.use_stride(4);
  EXPECT_EQ(clock.span(), 2);
  EXPECT_EQ(clock.units_to(5), 8);  // two strides of 2, of 4 units each
  EXPECT_EQ(clock.instant(5).units, 8);
  EXPECT_EQ(clock.instant(5).remainder, 1);
}

TEST(StrideClock, HasBegunOnceItHasLeftTheStart) {
  StrideClock<double> clock(1);
  EXPECT_FALSE(clock.has_begun());
  clock.advance_to(0x1p-1000);
  EXPECT_TRUE(clock.has_begun());
  EXPECT_TRUE(StrideClock<double>(1, {{1, 0}, 1}).has_begun());
}

}  // namespace
}  // namespace zenosphere
