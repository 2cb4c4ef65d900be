#include "collapse/finding.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zenosphere {
namespace {

constexpr double decades_looked_at = 100;

ApproachEvidence singular_evidence() {
  ApproachEvidence evidence;
  evidence.approach.is_spent = true;
  evidence.approach.visited = 0.9;
  evidence.approach.steady = SteadyFall{60, 0.1, 1.2};
  evidence.is_dissipative = true;
  return evidence;
}

TEST(Findings, SteadyFallOverTwentyDecadesWithDissipationIsSingular) {
  EXPECT_EQ(judge(singular_evidence(), decades_looked_at), Finding::singular);
}

TEST(Findings, NothingElasticIsSingular) {
  auto evidence = singular_evidence();
  evidence.is_dissipative = false;
  EXPECT_EQ(judge(evidence, decades_looked_at), Finding::undecided);
}

TEST(Findings, FallWithoutAPeriodInWhichTheClockGoesOnIsUndecided) {
  auto evidence = singular_evidence();
  evidence.clock_ratio = 0.5;
  EXPECT_EQ(judge(evidence, decades_looked_at), Finding::undecided);
}

TEST(Findings, FallOverNineteenDecadesIsUndecided) {
  auto evidence = singular_evidence();
  evidence.approach.steady->decades = 19;
  EXPECT_EQ(judge(evidence, decades_looked_at), Finding::undecided);
}

TEST(Findings, GapsThatReopenWithDigitsToSpareAreANearCollapse) {
  auto evidence = singular_evidence();
  evidence.approach.is_spent = false;
  evidence.approach.reopened_to = 10;
  EXPECT_EQ(judge(evidence, decades_looked_at), Finding::near_collapse);
}

TEST(Findings, GapsThatReopenWhereTheDigitsEndAreUndecided) {
  auto evidence = singular_evidence();
  evidence.approach.is_spent = false;
  evidence.approach.reopened_to = 10;
  evidence.approach.deepest = 98;
  EXPECT_EQ(judge(evidence, decades_looked_at), Finding::undecided);
  evidence.approach.deepest = 95;
  EXPECT_EQ(judge(evidence, decades_looked_at), Finding::near_collapse);
}

TEST(Findings, ZeroGapsThatHaveNotDecayedAreAnExactContact) {
  auto evidence = singular_evidence();
  evidence.approach.visited = 0;
  EXPECT_EQ(judge(evidence, decades_looked_at), Finding::exact_contact);
}

/// Durations x_n of rounds with x_n = a r^n + b s^n.
std::vector<double> durations(double a, double r, double b, double s, int rounds) {
  std::vector<double> all;
  for (int n = 0; n < rounds; ++n) all.push_back(a * std::pow(r, n) + b * std::pow(s, n));
  return all;
}

TEST(RoundRatios, OfTwoRealEigenvaluesConverge) {
  const auto ratio = round_ratio(durations(1, 0.4, 1, 0.1, 24));
  ASSERT_TRUE(ratio);
  EXPECT_NEAR(ratio->ratio, 0.4, 1e-9);
  EXPECT_TRUE(converges(*ratio));
}

TEST(RoundRatios, OfComplexEigenvaluesDrift) {
  // r^n cos(n theta): it reopens at n = pi / (2 theta) = 157, long after these 100 rounds.
  std::vector<double> all;
  for (int n = 0; n < 100; ++n) all.push_back(std::pow(0.4, n) * std::cos(0.01 * n));
  const auto ratio = round_ratio(all);
  ASSERT_TRUE(ratio);
  EXPECT_FALSE(converges(*ratio));
}

TEST(RoundRatios, NeedEightRounds) { EXPECT_FALSE(round_ratio(durations(1, 0.4, 0, 1, 7))); }

TEST(Findings, WordWhoseRatioDriftsIsUndecided) {
  auto evidence = singular_evidence();
  evidence.ratio = RoundRatio{0.4, 1e-4, 2e-4};
  EXPECT_EQ(judge(evidence, decades_looked_at), Finding::undecided);
}

}  // namespace
}  // namespace zenosphere
