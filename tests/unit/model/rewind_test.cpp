#include "model/rewind.hpp"

#include <gtest/gtest.h>

#include "model/real.hpp"

namespace zenosphere {
namespace {

TEST(LongestWayBack, FollowsTheRoundingOfTheNumberType) {
  // A side of 32: 32 sqrt(2 x 4 x 2^-p x 32) = 2^(9 - p/2) with p = 52 and 112.
  EXPECT_EQ(longest_way_back(32.0), 0x1p-17);
  EXPECT_EQ(longest_way_back(Quad(32)), Quad(0x1p-47));
  EXPECT_EQ(longest_way_back(128.0), 0x1p-16);  // as the square root of the side
}

}  // namespace
}  // namespace zenosphere
