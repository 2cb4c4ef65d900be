#include "model/precision.hpp"

#include <gtest/gtest.h>

#include "model/gap_threshold.hpp"
#include "model/real.hpp"

namespace zenosphere {
namespace {

TEST(Precision, EveryWordComesBack) {
  for (const std::string word : {"double", "extended", "quad"}) {
    EXPECT_EQ(Precision::from_word(word).value().word(), word);
  }
  for (int decimal = 20; decimal <= 10000; ++decimal) {
    const std::string word = "digits" + std::to_string(decimal);
    const auto precision = Precision::from_word(word);
    ASSERT_EQ(precision, Precision::digits(decimal));
    ASSERT_EQ(precision->word(), word);
    ASSERT_TRUE(is_precision_of_bits(precision->bits()));
    ASSERT_GE(precision->bits(), decimal * 3.3219280948873623);  // log2(10)
  }
}

TEST(Precision, OtherWordsAreNone) {
  for (const char* word :
       {"", "digits", "digits19", "digits10001", "digits0100", "digits100 ", "digits-100",
        "digits+100", "digits1e3", "Double", "half", "digits99999999999999999999"}) {
    EXPECT_FALSE(Precision::from_word(word)) << word;
  }
}

TEST(Precision, IsOrderedByTheBitsOfTheSignificand) {
  EXPECT_LT(Precision::double_precision, Precision::extended);
  EXPECT_LT(Precision::extended, Precision::digits(20));
  EXPECT_LT(Precision::digits(33), Precision::quad);  // 111 bits and 113
  EXPECT_GT(Precision::digits(34), Precision::quad);  // 114
  EXPECT_LT(Precision::digits(100), Precision::digits(101));
  EXPECT_FALSE(is_precision_of_bits(63));
}

// 1e-16 times 2^-(bits - 53): for 3324 bits 1e-16 x 2^-3271 = 2.14e-1001.
TEST(GapThreshold, FollowsThePrecisionBelowTheRangeOfDouble) {
  EXPECT_EQ(GapThreshold(Precision::digits(100)), GapThreshold(1e-16 * 0x1p-281));
  const GapThreshold threshold(Precision::digits(1000));
  EXPECT_NEAR(threshold.log10(), -16 - 3271 * std::log10(2), 1e-9);
  EXPECT_FALSE(threshold.fits_double());
  EXPECT_EQ(threshold.nearest_double(), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(threshold.in<Digits>(), ldexp(Digits(1e-16), -3271));
  EXPECT_NE(threshold.in<Quad>(), 0);    // its range ends at 1e-4965
  EXPECT_EQ(threshold.in<double>(), 0);  // there only a gap of 0 is not above it
  EXPECT_LT(threshold, GapThreshold(1e-300));
  EXPECT_LT(GapThreshold(Precision::digits(1001)), threshold);
}

TEST(GapThreshold, TextComesBack) {
  for (int decimal = 20; decimal <= 10000; decimal += 17) {
    const GapThreshold threshold(Precision::digits(decimal));
    ASSERT_EQ(GapThreshold::from_text(threshold.text()), threshold) << decimal;
  }
  EXPECT_EQ(GapThreshold::from_text("1e-1000").value().text(), "1e-1000");
  EXPECT_EQ(GapThreshold::from_text("1e-16"), GapThreshold(1e-16));
  for (const char* nonsense : {"", "0", "-1e-16", "nan", "inf", "1e400", "1e-16 m", "small"}) {
    EXPECT_FALSE(GapThreshold::from_text(nonsense)) << nonsense;
  }
}

}  // namespace
}  // namespace zenosphere
