#include "model/vec.hpp"

#include <gtest/gtest.h>

namespace zenosphere {
namespace {

TEST(Vec, AddsSubtractsAndScalesByComponent) {
  const Vec<3, double> a{{1, -2, 4}};
  const Vec<3, double> b{{0.5, 3, -1}};
  EXPECT_EQ(a + b, (Vec<3, double>{{1.5, 1, 3}}));
  EXPECT_EQ(a - b, (Vec<3, double>{{0.5, -5, 5}}));
  EXPECT_EQ(a * -0.5, (Vec<3, double>{{-0.5, 1, -2}}));
}

TEST(Vec, IsZeroWithoutValues) { EXPECT_EQ((Vec<2, double>{}), (Vec<2, double>{{0, 0}})); }

TEST(Vec, DotIsTheSumOfProducts) {
  // 1 x 4 - 2 x 5 + 3 x 6 = 12.
  EXPECT_EQ(dot(Vec<3, double>{{1, -2, 3}}, Vec<3, double>{{4, 5, 6}}), 12);
  EXPECT_EQ(dot(Vec<1, double>{{3}}, Vec<1, double>{{-2}}), -6);
}

TEST(Vec, DotSumsFromTheFirstComponentToTheLast) {
  // (1 + 2^-53) + 2^-53 rounds to 1 twice; 1 + (2^-53 + 2^-53) would be 1 + 2^-52.
  const Vec<3, double> ones{{1, 1, 1}};
  EXPECT_EQ(dot(ones, Vec<3, double>{{1, 0x1p-53, 0x1p-53}}), 1);
  EXPECT_EQ(dot(ones, Vec<3, double>{{0x1p-53, 0x1p-53, 1}}), 1 + 0x1p-52);
}

TEST(Vec, DotRoundsEachProduct) {
  // (1 + 2^-30)^2 = 1 + 2^-29 + 2^-60 rounds to 1 + 2^-29; contraction into one multiply-add would
  // keep the 2^-60. The number is volatile so that the compiler cannot work it out beforehand.
  volatile double number = 1 + 0x1p-30;
  const double x = number;
  EXPECT_EQ(dot(Vec<2, double>{{-1, x}}, Vec<2, double>{{1 + 0x1p-29, x}}), 0);
}

}  // namespace
}  // namespace zenosphere
