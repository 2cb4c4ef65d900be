#include "run/judge_group.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace zenosphere {
namespace {

/// Zero gaps of three spheres, which have not decayed.
SeenApproach zero_gaps(double begin_depth) {
  SeenApproach seen;
  seen.spheres = {0, 1, 2};
  seen.first_collision = 60;
  seen.evidence.approach.is_spent = true;
  seen.begin_depth = begin_depth;
  return seen;
}

/// Gaps of the same spheres that fell over 90 decades before.
SeenApproach spent() {
  SeenApproach seen;
  seen.spheres = {0, 1, 2};
  seen.first_collision = 50;
  seen.evidence.approach.is_spent = true;
  seen.evidence.approach.visited = 0.9;
  seen.evidence.approach.steady = SteadyFall{90, 0.1, 1.2};
  seen.evidence.is_dissipative = true;
  return seen;
}

/// A run in double, and what a hundred digits make of a state at its collision 40.
std::vector<FollowedGroup> ladder(std::vector<SeenApproach> seen) {
  FollowedGroup run;
  run.limit = 16;
  run.begin = {40};
  FollowedGroup top;
  top.limit = 100;
  top.begin = {40};
  top.seen = std::move(seen);
  top.trial.precision = Precision::digits(100);
  return {run, top};
}

const HitGroup group{.first_hit = 60, .last_hit = 60, .i = 0, .j = 1, .spheres = {0, 1, 2}};

TEST(JudgedGroups, ZeroGapsMadeFromSeparatedSpheresAreAnExactContact) {
  const auto judged = judge_group(group, ladder({zero_gaps(11)}));
  ASSERT_EQ(judged.size(), 1u);
  EXPECT_EQ(judged[0].finding, Finding::exact_contact);
  EXPECT_EQ(judged[0].decades, 0);
  EXPECT_EQ(judged[0].followed_from, 40);
}

// 1e-13 diameters are a few hundred units in the last place of a coordinate in double.
TEST(JudgedGroups, ZeroGapsThatTheRunHadRoundedBeforeAreUndecided) {
  const auto judged = judge_group(group, ladder({zero_gaps(13)}));
  ASSERT_EQ(judged.size(), 1u);
  EXPECT_EQ(judged[0].finding, Finding::undecided);
  EXPECT_NE(judged[0].sentence.find("rounding of the run in double"), std::string::npos);
  EXPECT_NE(judged[0].sentence.find("at collision 40"), std::string::npos);
}

TEST(JudgedGroups, ZeroGapsAfterTheEndOfTheDigitsAreUndecided) {
  const auto judged = judge_group(group, ladder({spent(), zero_gaps(3)}));
  ASSERT_EQ(judged.size(), 2u);
  EXPECT_EQ(judged[0].finding, Finding::singular);
  EXPECT_EQ(judged[1].finding, Finding::undecided);
  EXPECT_NE(judged[1].sentence.find("after the digits were spent at collision 50"),
            std::string::npos);
}

TEST(JudgedGroups, HitOfAPairThatDoesNotMeetInMoreDigitsIsUndecided) {
  const auto judged = judge_group(group, ladder({}));
  ASSERT_EQ(judged.size(), 1u);
  EXPECT_EQ(judged[0].finding, Finding::undecided);
  EXPECT_NE(judged[0].sentence.find("do not meet in digits100"), std::string::npos);
}

}  // namespace
}  // namespace zenosphere
