#include "case/case_limits.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "unit/case/case_texts.hpp"

namespace zenosphere {
namespace {

using case_format::excess_in;

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int n = 0; n < times; ++n) result += text;
  return result;
}

/// The text with every @ replaced.
std::string with_dots(std::string_view text, const std::string& dots) {
  std::string result;
  for (const char c : text) result += c == '@' ? dots : std::string(1, c);
  return result;
}

TEST(CaseLimits, KeysOfSixteenPartsPassAndOnesOfMoreAreNamedByLine) {
  EXPECT_FALSE(excess_in(fmt::format("a{} = 1\n", repeated(".a", 15))));
  const auto excess = excess_in(fmt::format("x = 1\na{} = 1\n", repeated(".a", 16)));
  ASSERT_TRUE(excess);
  EXPECT_EQ(excess->line, 2);
  EXPECT_EQ(excess->what, "key of more than 16 parts; shorten it");
  EXPECT_TRUE(excess_in(fmt::format("[a{}]\n", repeated(". \"b\" ", 16))));
}

TEST(CaseLimits, SixteenBracketsWithinEachOtherPassAndMoreAreRefused) {
  EXPECT_FALSE(excess_in(repeated("[", 16) + repeated("]", 16)));
  EXPECT_TRUE(excess_in(repeated("[\n{", 9)));
  EXPECT_FALSE(excess_in(fmt::format("x = [{}]", repeated("[1.5, 2.5],\n", 1000))));
}

TEST(CaseLimits, WhatStandsInStringsAndCommentsIsNotMeasured) {
  const std::string dots = repeated(".", 40) + repeated("[", 40);
  for (const std::string_view text : {"# @", "x = \"@\"", "x = '@'", "x = \"\\\"@\"",
                                      "x = \"\"\"\n@\\\"\"\"\"", "x = '''@\n''@'''"}) {
    EXPECT_FALSE(excess_in(with_dots(text, dots))) << text;
  }
}

TEST(CaseLimits, WhatFollowsAStringIsMeasured) {
  const std::string dots = repeated(".a", 40);
  for (const std::string_view text :
       {"\"x\"@", "'\\'@", "x = \"\"\"\"\"\"@", "x = \"\"\"a\"\"\"\"\"@", "x = '''a''''@",
        "x = \"no end\n@", "x = [\"\"\"\n\"\"\", {a@"}) {
    EXPECT_TRUE(excess_in(with_dots(text, dots))) << text;
  }
}

TEST(CaseLimits, TablesTooDeepForTheStackAreRefusedBeforeTheyAreRead) {
  // 125 inline tables on lines of their own, each with a key of 4900 parts: 600 000 levels.
  const std::string level = fmt::format("[\n{{a{} = ", repeated(".a", 4899));
  const std::string text = fmt::format("x = {}1{}", repeated(level, 125), repeated("}\n]", 125));
  EXPECT_EQ(problems_of(text), "e.toml:2:1: key of more than 16 parts; shorten it");
}

TEST(CaseLimits, AFileOfMoreThanAThousandKeysIsNoCase) {
  std::string text;
  for (int n = 0; n < 1001; ++n) text += fmt::format("k{} = 1\n", n);
  EXPECT_EQ(problems_of(text),
            "e.toml: more than 1000 keys and tables; check that it is the case file");
  EXPECT_EQ(problems_of(cooling_case, std::vector<std::string>(1001, "run.time=1")),
            "--set: 1001 overrides (must be at most 1000); write a case file");
}

}  // namespace
}  // namespace zenosphere
