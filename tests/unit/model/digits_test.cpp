#include "model/digits.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <utility>
#include <vector>

#include "model/real.hpp"

namespace zenosphere {
namespace {

constexpr int hundred = bits_of_digits(100);
constexpr int thousand = bits_of_digits(1000);

Digits third_of(int bits) {
  const WorkingPrecision here(bits);
  return Digits(1) / 3;
}

TEST(Digits, HundredTakeThe334BitsThatTheyAlwaysTook) {
  EXPECT_EQ(hundred, 334);
  EXPECT_EQ(Digits(1).bits(), 334);  // also where no precision was asked for
}

TEST(Digits, NumbersHaveThePrecisionOfTheInnermostScope) {
  const WorkingPrecision outer(thousand);
  EXPECT_EQ(Digits(1).bits(), thousand);
  EXPECT_EQ(significand_bits<Digits>(), thousand);
  {
    const WorkingPrecision inner(68);
    EXPECT_EQ(Digits("0.1").bits(), 68);
  }
  EXPECT_EQ(Digits().bits(), thousand);
}

TEST(Digits, ThreadsHaveTheirOwnPrecision) {
  const WorkingPrecision here(thousand);
  int there = 0;
  std::thread([&] { there = Digits(1).bits(); }).join();
  EXPECT_EQ(there, hundred);
}

TEST(Digits, EpsilonIsTheDistanceFromOneToTheNext) {
  for (const int bits : {68, hundred, 384, 385, thousand}) {
    const WorkingPrecision here(bits);
    const Digits epsilon = std::numeric_limits<Digits>::epsilon();
    EXPECT_GT(1 + epsilon, 1) << bits;
    EXPECT_EQ(1 + epsilon / 2, 1) << bits;  // a tie, to even
  }
}

// 3 x (1/3) rounds to 1, and the error of a third of n bits is a third of its last place.
TEST(Digits, ThirdIsRightToItsLastPlaceInPlaceAndBeyond) {
  for (const int bits : {68, hundred, 384, 385, thousand, bits_of_digits(10000)}) {
    const WorkingPrecision twice(2 * bits + 8);
    const Digits third = third_of(bits).in_working_precision();
    const Digits error = abs(third * 3 - 1);
    EXPECT_GT(error, 0) << bits;
    EXPECT_LE(error, ldexp(Digits(1), -bits)) << bits;
  }
}

TEST(Digits, ResultHasThePrecisionOfTheLongerOperand) {
  const Digits mixed = Digits(1) + third_of(thousand);
  EXPECT_EQ(mixed.bits(), thousand);
  EXPECT_LE(abs(mixed - 1 - third_of(thousand)), ldexp(Digits(1), -thousand));
  Digits sum = third_of(hundred);
  sum -= third_of(thousand);
  EXPECT_EQ(sum.bits(), thousand);
  EXPECT_LT(abs(sum), Digits("1e-100"));
  EXPECT_NE(sum, 0);
}

TEST(Digits, CopiesAndMovesKeepValueAndPrecisionWhereverTheSignificandIs) {
  const std::vector<Digits> numbers{third_of(68), third_of(384), third_of(385), third_of(thousand)};
  for (const Digits& from : numbers) {
    for (const Digits& to : numbers) {
      Digits target = to;
      target = from;
      EXPECT_EQ(target, from);
      EXPECT_EQ(target.bits(), from.bits());
      Digits source = from;
      target = to;
      target = std::move(source);
      EXPECT_EQ(target, from);
      source = to;  // what was moved from can be given a value
      EXPECT_EQ(source, to);
      std::swap(source, target);
      EXPECT_EQ(source, from);
      EXPECT_EQ(target, to);
    }
  }
}

TEST(Digits, ComparesWithNumbersOfTheProcessorAndNotWithNaN) {
  const WorkingPrecision here(thousand);
  const Digits tenth = Digits(1) / 10;
  EXPECT_NE(tenth, 0.1);
  EXPECT_LT(tenth, 0.1);  // the double is above
  EXPECT_GT(1, tenth);
  EXPECT_LT(Digits(-1), 0u);
  EXPECT_GT(ldexp(Digits(1), 64), ~std::uint64_t{0});
  const Digits nan = std::numeric_limits<Digits>::quiet_NaN();
  EXPECT_FALSE(nan < 1 || nan > 1 || nan == nan || nan <= tenth || nan >= tenth);
  EXPECT_GT(std::numeric_limits<Digits>::infinity(), tenth);
}

TEST(Digits, QuadGoesInAndOutInEveryBit) {
  const WorkingPrecision here(thousand);
  for (const Quad& number : {Quad(1) / 3, Quad(-1) / 3, ldexp(Quad(1) / 3, 16000),
                             ldexp(Quad(1) / 3, -16000), Quad(0)}) {
    EXPECT_EQ(static_cast<Quad>(Digits(number)), number);
  }
  EXPECT_LT(abs(Digits(Quad(1) / 3) * 3 - 1), Digits("1e-33"));
}

TEST(Digits, TextHoldsAllDigitsAndIsReadAsTheSameNumber) {
  for (const int decimal : {20, 100, 101, 1000}) {
    const WorkingPrecision here(bits_of_digits(decimal));
    const Digits third = Digits(1) / 3;
    const std::string text = to_decimal(third);
    EXPECT_GE(static_cast<int>(text.size()), decimal + 2);
    EXPECT_EQ(Digits(text), third);
  }
  EXPECT_EQ(Digits("1e-4000").str(3), "1e-4000");
  EXPECT_THROW(Digits("1e-4000 or so"), std::runtime_error);
}

}  // namespace
}  // namespace zenosphere
