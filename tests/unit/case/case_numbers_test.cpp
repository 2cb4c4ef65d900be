#include "case/case_numbers.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "unit/case/case_texts.hpp"

namespace zenosphere {
namespace {

using case_format::first_wrong_number;
using case_format::number_objection;

TEST(CaseNumbers, WhatWouldBeReadAsZeroOrInfinityIsRefusedWithTheLimit) {
  const std::string small =
      " (real numbers other than 0 are at least 4.94e-324); write 0 or a "
      "larger one";
  EXPECT_EQ(number_objection("1e-400"), "1e-400" + small);
  EXPECT_EQ(number_objection("-0.5e-400"), "-0.5e-400" + small);
  EXPECT_EQ(number_objection("1e400"), "1e400 (real numbers are at most 1.8e+308)");
  for (const char* right : {"0e-400", "0.0", "-0.0", "2.3e-308", "5e-324", "1.7e308", "1e-99"}) {
    EXPECT_FALSE(number_objection(right)) << right;
  }
}

TEST(CaseNumbers, IntegersBeyondTheirRangeAreRefusedWithTheLimit) {
  EXPECT_EQ(number_objection("99999999999999999999"),
            "99999999999999999999 (too large: integers are at most 9223372036854775807); where a "
            "real number will do, write 1e+20");
  EXPECT_EQ(number_objection("-99999999999999999999"),
            "-99999999999999999999 (too small: integers are at least -9223372036854775808); where "
            "a real number will do, write -1e+20");
  EXPECT_FALSE(number_objection("9223372036854775807"));
  EXPECT_FALSE(number_objection("-9223372036854775808"));
}

TEST(CaseNumbers, WhatTomlDoesNotTakeIsSaidAsItWould) {
  EXPECT_EQ(number_objection(".3"), ".3 (needs a digit in front of the point); write 0.3");
  EXPECT_EQ(number_objection("-.3e5"), "-.3e5 (needs a digit in front of the point); write -0.3e5");
  EXPECT_EQ(number_objection("5."), "5. (needs a digit behind the point); write 5.0");
  EXPECT_EQ(number_objection("0,3"), "0,3 (needs a point, not a comma); write 0.3");
  EXPECT_EQ(number_objection("007"), "007 (begins with 0); write 7");
  EXPECT_EQ(number_objection("00.5"), "00.5 (begins with 0); write 0.5");
}

TEST(CaseNumbers, UnderscoresBetweenDigitsAreNoPartOfANumber) {
  for (const char* small : {"1_0e-400", "-1_0.0_1e-4_00", "1e-4_0_0"}) {
    const auto wrong = first_wrong_number(fmt::format("x = [{}]", small));
    ASSERT_TRUE(wrong) << small;
    EXPECT_NE(wrong->objection.find("e-4"), std::string::npos) << wrong->objection;
  }
  EXPECT_EQ(number_objection("1_0e40_0"), "1_0e40_0 (real numbers are at most 1.8e+308)");
  EXPECT_EQ(number_objection(".1_5"), ".1_5 (needs a digit in front of the point); write 0.15");
  EXPECT_EQ(number_objection("0_7"), "0_7 (begins with 0); write 7");
  EXPECT_TRUE(number_objection("99_999_999_999_999_999_999"));
  for (const char* right :
       {"1_000", "-1_0.2_5e-1_0", "0.0_0", "0e-4_00", "9_223372036854775_807"}) {
    EXPECT_FALSE(number_objection(right)) << right;
  }
  for (const char* wrong : {"1__0", "_1", "1_", "1_.0", "1._0", "1e_5", "1_e5", "1__0e-400"}) {
    EXPECT_FALSE(number_objection(wrong)) << wrong << ": toml++ says what is wrong";
  }
}

TEST(CaseNumbers, ANumberOfAnyLengthIsLookedAt) {
  const std::string small = "0." + std::string(1000, '0') + "1";
  EXPECT_EQ(number_objection(small),
            fmt::format("{}... (real numbers other than 0 are at least 4.94e-324); write 0 or a "
                        "larger one",
                        small.substr(0, 60)));
  EXPECT_EQ(number_objection(std::string(1000, '9')),
            std::string(60, '9') + "... (too large: integers are at most 9223372036854775807)");
  EXPECT_FALSE(number_objection("0." + std::string(1000, '3')));
}

TEST(CaseNumbers, WhatIsNoDecimalNumberIsLeftToToml) {
  for (const char* other : {"true", "inf", "nan", "0x1F", "1_000", "2020-01-01", "07:32:00", "-",
                            ".", "1e", "O.5", "1.2.3", ""}) {
    EXPECT_FALSE(number_objection(other)) << other;
  }
}

TEST(CaseNumbers, OnlyValuesAreLookedAt) {
  for (const char* right :
       {"# 1e-400\n", "x = \"1e-400\"\n", "[007]\n", "\"1e-400\" = 1\n", "x = 07:32:00\n",
        "x = [1, 2,\n3]\n007 = 1\n", "x = {a = 1,b = 2}", "x = 1 # .3\n", "x = [1,2]\n"}) {
    EXPECT_FALSE(first_wrong_number(right)) << right;
  }
  const auto wrong = first_wrong_number("x = '''1e-400'''\ny = [1, [2.0,\n 1e-400]]");
  ASSERT_TRUE(wrong);
  EXPECT_EQ(wrong->at, 32);
}

TEST(CaseNumbers, AWrongNumberOfAFileIsNamedWithItsPlace) {
  EXPECT_EQ(problems_of(replaced(cooling_case, "= 0.9", "= 1e-400")),
            "e.toml:5:15: 1e-400 (real numbers other than 0 are at least 4.94e-324); write 0 or a "
            "larger one");
  EXPECT_EQ(problems_of(replaced(cooling_case, "= 0.9", "= .9")),
            "e.toml:5:15: .9 (needs a digit in front of the point); write 0.9");
  EXPECT_EQ(problems_of(replaced(cooling_case, "= 0.9", "= 0,9")),
            "e.toml:5:15: 0,9 (needs a point, not a comma); write 0.9");
}

TEST(CaseNumbers, AWrongNumberWithUnderscoresIsNamedWithItsPlace) {
  EXPECT_EQ(problems_of(replaced(cooling_case, "= 0.9", "= 1_0e-400")),
            "e.toml:5:15: 1_0e-400 (real numbers other than 0 are at least 4.94e-324); write 0 or "
            "a larger one");
  EXPECT_EQ(objection(cooling_case, "start.positions=[[1, 2_0e-400, 3]]"),
            "start.positions = 2_0e-400 (real numbers other than 0 are at least 4.94e-324); write "
            "0 or a larger one");
}

TEST(CaseNumbers, AWrongNumberOfAnOverrideIsNamedWithItsKey) {
  EXPECT_EQ(objection(cooling_case, "system.restitution=.3"),
            "system.restitution = .3 (needs a digit in front of the point); write 0.3");
  EXPECT_EQ(objection(cooling_case, "system.restitution=0,3"),
            "system.restitution = 0,3 (needs a point, not a comma); write 0.3");
  EXPECT_EQ(objection(cooling_case, "start.seed=99999999999999999999"),
            "start.seed = 99999999999999999999 (too large: integers are at most "
            "9223372036854775807); where a real number will do, write 1e+20");
  EXPECT_EQ(objection(cooling_case, "run.time=1e-400"),
            "run.time = 1e-400 (real numbers other than 0 are at least 4.94e-324); write 0 or a "
            "larger one");
}

}  // namespace
}  // namespace zenosphere
