#include "run/precision_ladder.hpp"

#include <gtest/gtest.h>

namespace zenosphere {
namespace {

TEST(PrecisionLadder, FirstJudgeHasAHundredDigitsOrTwiceThoseOfTheRun) {
  EXPECT_EQ(first_judge(Precision::double_precision), Precision::digits(100));
  EXPECT_EQ(first_judge(Precision::quad), Precision::digits(100));
  EXPECT_EQ(first_judge(Precision::digits(100)), doubled(Precision::digits(100)));
  EXPECT_LT(Precision::digits(199), first_judge(Precision::digits(100)));
}

TEST(PrecisionLadder, GoesUpFromThatOfTheRunToTheHighest) {
  const auto ladder =
      precision_ladder(Precision::extended, Precision::digits(150), Precision::digits(400));
  ASSERT_EQ(ladder.size(), 5u);
  EXPECT_EQ(ladder[0], Precision::extended);
  EXPECT_EQ(ladder[1], Precision::quad);
  EXPECT_EQ(ladder[2], Precision::digits(100));
  EXPECT_EQ(ladder[3], Precision::digits(150));
  EXPECT_EQ(ladder[4], doubled(Precision::digits(150)));
}

}  // namespace
}  // namespace zenosphere
