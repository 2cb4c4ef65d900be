#include "proof/invariant_cone.hpp"

#include <gtest/gtest.h>

#include "model/repeated_round.hpp"
#include "proof/letters.hpp"
#include "proof/rational_eigenvalue.hpp"

namespace zenosphere {
namespace {

TEST(InvariantCone, HoldsItsVectorAndBoundsEveryImage) {
  // Eigenvalues 3, 1, 1/2, with a shear between them.
  const RationalMatrix a{{3, 1, 0}, {0, 1, 1}, {0, 0, Rational(1, 2)}};
  RationalVector y{5, Rational(1, 7), Rational(-1, 3)};
  const auto cone = InvariantCone::around(y, a);
  ASSERT_TRUE(cone);
  EXPECT_LT(cone->growth().lower, 3);
  EXPECT_GT(cone->growth().upper, 3);
  const RationalVector form{1, 2, -1};
  const Enclosure range = cone->range(form);
  for (int k = 0; k < 20; ++k) {
    const Rational height = cone->height(y);
    const Rational value = (y[0] + 2 * y[1] - y[2]) / height;
    EXPECT_GE(value, range.lower);
    EXPECT_LE(value, range.upper);
    y = product(a, y);
    EXPECT_GE(cone->height(y), cone->growth().lower * height);
    EXPECT_LE(cone->height(y), cone->growth().upper * height);
  }
}

TEST(InvariantCone, IsNotWhereTheLargestEigenvalueTurnsOrIsNegative) {
  const RationalVector y{1, 0};
  EXPECT_FALSE(InvariantCone::around(y, {{0, -1}, {1, 0}}));
  EXPECT_FALSE(InvariantCone::around(y, {{-2, 0}, {0, 1}}));
  EXPECT_FALSE(InvariantCone::around(y, {{1, 1}, {0, 1}}));  // a Jordan block
}

TEST(InvariantCone, HoldsWhereSmallerEigenvaluesTurn) {
  // 2 and (3 +- 4 i)/10: of the same modulus 1/2, turned by 53 degrees.
  const RationalMatrix a{
      {2, 0, 0}, {0, Rational(3, 10), Rational(-4, 10)}, {0, Rational(4, 10), Rational(3, 10)}};
  EXPECT_TRUE(InvariantCone::around({1, Rational(1, 3), Rational(1, 5)}, a));
}

TEST(InvariantCone, IsNotWhereAnImageLeavesIt) {
  // 1 and 5/8 (1 +- i), of modulus 0.88: |z_1| and |z_2| of (1, r, -r) become 5/4 r and 0.
  const RationalMatrix a{
      {1, 0, 0}, {0, Rational(5, 8), Rational(-5, 8)}, {0, Rational(5, 8), Rational(5, 8)}};
  EXPECT_FALSE(InvariantCone::around({1, Rational(1, 3), Rational(1, 5)}, a));
}

TEST(ExteriorSquare, MapsTheMinors) {
  const RationalMatrix a{{1, 2, 0}, {Rational(1, 3), -1, 4}, {2, 0, 5}};
  const RationalVector x{1, 2, 3};
  const RationalVector y{-1, 0, 4};
  EXPECT_EQ(product(exterior_square(a), minors(x, y)), minors(product(a, x), product(a, y)));
  EXPECT_EQ(minors(x, y)[minor_index(1, 2, 3)], 8);
}

TEST(SimplestBetween, IsTheFractionOfTheSmallestDenominator) {
  EXPECT_EQ(simplest_between({exact_number("3.14"), exact_number("3.15")}), Rational(22, 7));
  EXPECT_EQ(simplest_between({exact_number("0.15999999"), exact_number("0.16000001")}),
            Rational(4, 25));
  EXPECT_EQ(simplest_between({2, 2}), 2);
  EXPECT_EQ(simplest_between({exact_number("1.5"), exact_number("2.5")}), 2);
}

TEST(RepeatingWord, IsTheShortestThatRepeatsThreeTimes) {
  const auto word = [](const std::vector<int>& history) {
    const auto found = round_at_end(history);
    return found ? text_of_letters(first_rotation(*found)) : "";
  };
  EXPECT_EQ(word({5, 0, 1, 0, 1, 0, 1}), "ab");
  EXPECT_EQ(word({1, 2, 1, 0, 1, 2, 1, 0, 1, 2, 1, 0}), "abcb");
  EXPECT_EQ(word({0, 1, 2, 0, 1, 0, 1, 2}), "");
}

TEST(RepeatingWord, LettersAroundTheLastHangTogether) {
  using Letters = std::vector<int>;
  EXPECT_EQ(letters_around_last(Letters{7, 0, 1, 5, 0, 1}, 0), (Letters{0, 1}));
  EXPECT_EQ(letters_around_last(Letters{9, 0, 1, 5, 0, 1}, 10), (Letters{9, 0, 1}));
  EXPECT_EQ(letters_around_last(Letters{0, 1, 2}, 3), Letters{});  // nothing is missing
}

}  // namespace
}  // namespace zenosphere
