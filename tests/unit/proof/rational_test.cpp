#include "proof/rational.hpp"

#include <gtest/gtest.h>

namespace zenosphere {
namespace {

TEST(Rational, PlacesAreOneMoreThanTheFirstDigitOfAWidth) {
  EXPECT_EQ(places_for(Rational(2, 1000)), 4);
  EXPECT_EQ(places_for(Rational(7, 10)), 2);
  EXPECT_EQ(places_for(30), 0);
}

TEST(Rational, DecimalsBelowAndAboveHoldTheNumber) {
  const Rational third(1, 3);
  EXPECT_EQ(decimal_below(third, 4), "0.3333");
  EXPECT_EQ(decimal_above(third, 4), "0.3334");
  EXPECT_EQ(decimal_below(-third, 4), "-0.3334");
  EXPECT_EQ(decimal_above(-third, 4), "-0.3333");
  EXPECT_EQ(decimal_below(Rational(1, 2), 1), decimal_above(Rational(1, 2), 1));
}

}  // namespace
}  // namespace zenosphere
