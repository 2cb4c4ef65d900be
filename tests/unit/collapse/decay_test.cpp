#include "collapse/decay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "model/real.hpp"

namespace zenosphere {
namespace {

/// Collisions of pairs that take turns; gap, speed and flight shrink by factors at each.
template <class Real>
std::vector<ClusterStep<Real>> geometric(int count, int pairs, const Real& gap, const Real& speed) {
  std::vector<ClusterStep<Real>> steps;
  ClusterStep<Real> step{0, 0, 1, 1, 1};
  for (int n = 0; n < count; ++n) {
    step.pair = n % pairs;
    step.time += step.flight;
    steps.push_back(step);
    step.gap *= gap;
    step.normal_speed *= speed;
    step.flight *= gap / speed;
  }
  return steps;
}

TEST(Decay, FindsTheFactorsOfAGeometricSeries) {
  for (const int pairs : {1, 2, 4}) {
    const Decay decay = decay_of<double>(geometric(24, pairs, 0.125, 0.4), 1);
    EXPECT_EQ(decay.cycle, pairs);
    EXPECT_NEAR(decay.gap->ratio, 0.125, 1e-14);
    EXPECT_NEAR(decay.speed->ratio, 0.4, 1e-14);
    EXPECT_NEAR(decay.flight->ratio, 0.3125, 1e-14);
    EXPECT_NEAR(decay.gap->spread, 0, 1e-14);
    // 1 + 0.3125 + ... = 1/(1 - 0.3125) = 16/11.
    EXPECT_NEAR(decay.collapse_time_after.value(), 16.0 / 11, 1e-12);
    EXPECT_LT(decay.collapse_time_error, 1e-12);
  }
}

TEST(Decay, GivesTheFactorPerCollisionWherePairsAreNotAlike) {
  // Gaps shrink by 1/2 and 1/8 in turn: 1/4 per collision, over cycles of two.
  std::vector<ClusterStep<double>> steps;
  double gap = 1;
  for (int n = 0; n < 12; ++n) {
    steps.push_back({n % 2, static_cast<double>(n), 1, gap, 1});
    gap *= n % 2 == 0 ? 0.5 : 0.125;
  }
  EXPECT_NEAR(decay_of<double>(steps, 1).gap->ratio, 0.25, 1e-14);
  EXPECT_NEAR(decay_of<double>(steps, 1).gap->spread, 0, 1e-14);
}

TEST(Decay, DoesNotCountWhatRoundingHasSpoilt) {
  auto steps = geometric<double>(24, 2, 0.125, 0.4);
  for (auto& step : steps) {
    if (step.gap < 1e-12) step.gap = 1e-13;  // noise at the end
  }
  EXPECT_NEAR(decay_of<double>(steps, 1).gap->ratio, 0.125, 1e-14);
}

TEST(Decay, IsUnknownForASingleCollisionOfEachPair) {
  const Decay decay = decay_of<double>(geometric(2, 2, 0.5, 0.5), 1);
  EXPECT_FALSE(decay.gap);
  EXPECT_FALSE(decay.speed);
  EXPECT_FALSE(decay.flight);
  EXPECT_FALSE(decay.collapse_time_after);
}

TEST(Decay, HasNoCollapseTimeWhereCyclesDoNotShrink) {
  EXPECT_FALSE(decay_of<double>(geometric(24, 2, 0.5, 0.5), 1).collapse_time_after);
  EXPECT_FALSE(decay_of<double>(geometric(24, 2, 0.5, 0.4), 1).collapse_time_after);
}

TEST(Decay, MeasuresABounceByItsFlights) {
  // Gaps counted from contact are zero; flights and speeds halve, and 1 + 1/2 + ... = 2.
  auto steps = geometric<double>(20, 1, 0.25, 0.5);
  for (auto& step : steps) step.gap = 0;
  const Decay decay = decay_of<double>(steps, 1);
  EXPECT_FALSE(decay.gap);
  EXPECT_NEAR(decay.speed->ratio, 0.5, 1e-15);
  EXPECT_NEAR(decay.flight->ratio, 0.5, 1e-15);
  EXPECT_NEAR(decay.collapse_time_after.value(), 2, 1e-12);
}

TEST(Decay, FollowsASeriesToAHundredDigits) {
  const auto steps = geometric<Digits>(100, 2, Digits(1) / 8, Digits(2) / 5);
  const Decay decay = decay_of<Digits>(steps, 1);
  EXPECT_NEAR(decay.gap->ratio, 0.125, 1e-14);
  EXPECT_DOUBLE_EQ(decay.collapse_time_after.value(), 16.0 / 11);
  EXPECT_LT(decay.collapse_time_error, 1e-60);
}

TEST(ChainFactors, OfThreeBallsAreTheRootsOfTheirPolynomial) {
  const auto factors = chain_factors(3, 0.05).value();
  EXPECT_DOUBLE_EQ(factors.speed, 0.4);
  EXPECT_DOUBLE_EQ(factors.gap, 0.125);
  EXPECT_DOUBLE_EQ(factors.flight, 0.3125);
}

TEST(ChainFactors, ExistUpToTheThresholdOfTheChain) {
  for (const int balls : {3, 4, 5, 11}) {
    const double root = std::tan(std::numbers::pi / 4 * (1 - 2.0 / balls));
    EXPECT_TRUE(chain_factors(balls, 0.999999 * root * root)) << balls;
    EXPECT_FALSE(chain_factors(balls, 1.000001 * root * root)) << balls;
  }
  EXPECT_FALSE(chain_factors(2, 0.0));  // two balls part
}

}  // namespace
}  // namespace zenosphere
