#include "model/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace zenosphere {
namespace {

double ulp(double value) {
  const double size = std::abs(value);
  return std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
}

TEST(PortableLog, IsGoodToAFewUlps) {
  Random random(1);
  for (int n = 0; n < 100000; ++n) {
    const double uniform = random.uniform() + 0x1p-60;
    for (const double x : {uniform, uniform * 1e-9, uniform * 1e9, 0.5 + uniform}) {
      const double exact = std::log(x);
      // exponent x ln 2 and the series are each rounded; the series cancels less than half of it.
      ASSERT_NEAR(portable_log(x), exact, 4 * ulp(exact)) << "x = " << x;
    }
  }
}

TEST(PortableLog, IsExactAtOneAndNearIt) {
  EXPECT_EQ(portable_log(1), 0);
  // ln(1 + d) = d - d^2/2 + d^3/3 with d = 2^-20: the next term is 1e-18 of it.
  const double d = 0x1p-20;
  EXPECT_DOUBLE_EQ(portable_log(1 + d), d - d * d / 2 + d * d * d / 3);
  EXPECT_DOUBLE_EQ(portable_log(2), std::log(2.0));
  EXPECT_DOUBLE_EQ(portable_log(0x1p-1000), -1000 * std::log(2.0));
}

TEST(Random, UniformIsTheStandardGeneratorOnA53BitGrid) {
  // The C++ standard demands 9981545732273789042 as the 10000th number of mt19937_64(5489).
  Random random(5489);
  for (int n = 1; n < 10000; ++n) random.uniform();
  EXPECT_EQ(random.uniform(), static_cast<double>(9981545732273789042u >> 11) * 0x1p-53);
}

TEST(Random, UniformHasTheMomentsOfTheUnitInterval) {
  constexpr int draws = 1000000;
  Random random(2);
  double sum = 0;
  double squares = 0;
  for (int n = 0; n < draws; ++n) {
    const double value = random.uniform();
    ASSERT_GE(value, 0);
    ASSERT_LT(value, 1);
    sum += value;
    squares += value * value;
  }
  // Mean 1/2, variance 1/12; mean square 1/3, variance of the square 1/5 - 1/9 = 4/45.
  EXPECT_NEAR(sum / draws, 0.5, 5 * std::sqrt(1.0 / 12 / draws));
  EXPECT_NEAR(squares / draws, 1.0 / 3, 5 * std::sqrt(4.0 / 45 / draws));
}

TEST(Random, NormalHasTheMomentsOfTheNormalDistribution) {
  constexpr int draws = 1000000;
  Random random(3);
  double moments[4] = {};
  double product = 0;
  double before = 0;
  int beyond_two = 0;
  for (int n = 0; n < draws; ++n) {
    const double value = random.normal();
    double power = 1;
    for (double& moment : moments) moment += (power *= value) / draws;
    product += before * value / draws;
    before = value;
    if (std::abs(value) > 2) ++beyond_two;
  }
  // Five standard errors: variances of x, x^2, x^3, x^4 are 1, 2, 15, 96.
  const double five = 5 / std::sqrt(1.0 * draws);
  EXPECT_NEAR(moments[0], 0, five * std::sqrt(1.0));
  EXPECT_NEAR(moments[1], 1, five * std::sqrt(2.0));
  EXPECT_NEAR(moments[2], 0, five * std::sqrt(15.0));
  EXPECT_NEAR(moments[3], 3, five * std::sqrt(96.0));
  EXPECT_NEAR(product, 0, five);
  // P(|x| > 2) = erfc(sqrt 2) = 0.0455003.
  EXPECT_NEAR(1.0 * beyond_two / draws, 0.0455003, five * std::sqrt(0.0455 * 0.9545));
}

TEST(Random, BelowTakesEachValueEquallyOften) {
  constexpr int draws = 70000;
  Random random(4);
  std::vector<int> counts(7);
  for (int n = 0; n < draws; ++n) ++counts.at(static_cast<std::size_t>(random.below(7)));
  // Each has probability 1/7: five standard deviations of 10000 are 5 sqrt(10000 x 6/7) = 463.
  for (const int count : counts) EXPECT_NEAR(count, draws / 7, 463);
}

TEST(Random, SameSeedGivesTheSameStreamAndAnotherSeedAnother) {
  Random one(9);
  Random same(9);
  Random other(10);
  EXPECT_EQ(one.normal(), same.normal());
  EXPECT_NE(one.uniform(), other.uniform());
}

}  // namespace
}  // namespace zenosphere
