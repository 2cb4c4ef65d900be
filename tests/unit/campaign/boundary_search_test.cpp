#include "campaign/boundary_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "model/random.hpp"

namespace zenosphere {
namespace {

using Probability = std::function<double(double)>;

constexpr SearchRange restitution{.from = 0, .to = 1, .resolution = 0.1, .most_runs = 400};

Probability logistic(double c, double s) {
  return [=](double x) { return 1 / (1 + std::exp((x - c) / s)); };
}

/// A search among runs that meet the criterion with probability p(x).
BoundarySearch searched(const SearchRange& range, const Probability& p, std::uint64_t seed) {
  BoundarySearch search(range);
  Random random(seed);
  for (auto round = search.next_round(); !round.empty(); round = search.next_round()) {
    for (const double x : round) search.observe(x, random.uniform() < p(x));
  }
  return search;
}

/// How many of so many searches end with `crossing`, with an interval that holds c; their runs.
struct Coverage {
  int crossings = 0;
  int covered = 0;
  double mean_runs = 0;
};

Coverage coverage(const SearchRange& range, const Probability& p, double c, int searches) {
  Coverage result;
  for (int number = 0; number < searches; ++number) {
    const BoundarySearch search = searched(range, p, 1000 + number);
    const Estimate estimate = search.estimate();
    result.crossings += search.finding() == BoundaryFinding::crossing;
    result.covered += estimate.low <= c && c <= estimate.high;
    result.mean_runs += static_cast<double>(search.runs()) / searches;
  }
  return result;
}

TEST(BoundarySearch, FirstRoundIsSpreadEvenlyOverTheRange) {
  const SearchRange range{.from = 0.1, .to = 0.8, .resolution = 0.05, .most_runs = 100};
  EXPECT_EQ(BoundarySearch(range).next_round(),
            (std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8}));
}

TEST(BoundarySearch, StepIsBracketedByRunsOnBothSides) {
  const double c = 0.3141;
  SearchRange range = restitution;
  range.resolution = 0.001;
  const auto search = searched(
      range, [=](double x) { return x < c ? 1.0 : 0.0; }, 1);
  EXPECT_EQ(search.finding(), BoundaryFinding::crossing);
  EXPECT_LE(search.estimate().low, c);
  EXPECT_GE(search.estimate().high, c);
  // Eight cuts a round are a factor of nine, and 9^4 > 1000 > 9^3: four rounds after the first
  // would do without doubt about the slope; the doubt costs a few more.
  EXPECT_LE(search.runs(), 80);
}

TEST(BoundarySearch, IntervalHoldsTheCrossingAsOftenAsItSaysInFewerRunsThanAGrid) {
  const Coverage found = coverage(restitution, logistic(0.37, 0.05), 0.37, 100);
  EXPECT_GE(found.crossings, 95);
  EXPECT_GE(found.covered, 88);  // 95 of 100, less 3 standard errors of 2.2
  // A grid with steps of the resolution has 11 values. For an interval as long as the resolution
  // the standard error of c must be 0.0255 = sqrt(s step / n): 8 runs a value, 88 in all.
  EXPECT_LT(found.mean_runs, 60);
}

TEST(BoundarySearch, IntervalHoldsTheMedianOfAnotherResponseToo) {
  // 1 - exp(-exp(-(x - a) / s)): chance of a hit at a rate that falls exponentially; it is 1/2 at
  // a - s ln(ln 2).
  const double a = 0.4, s = 0.06, c = a - s * std::log(std::log(2.0));
  const auto rate = [=](double x) { return 1 - std::exp(-std::exp(-(x - a) / s)); };
  EXPECT_GE(coverage(restitution, rate, c, 100).covered, 88);
}

TEST(BoundarySearch, RisingResponseIsFoundAsWell) {
  const auto rising = [](double x) { return 1 - logistic(0.7, 0.02)(x); };
  const auto search = searched(restitution, rising, 3);
  EXPECT_EQ(search.finding(), BoundaryFinding::crossing);
  EXPECT_NEAR(search.estimate().place, 0.7, 0.06);  // 2.4 standard errors at most
}

TEST(BoundarySearch, NoCrossingIsSaidWithTheSide) {
  const auto never = searched(
      restitution, [](double) { return 0.0; }, 1);
  const auto always = searched(
      restitution, [](double) { return 1.0; }, 1);
  const auto seldom = searched(
      restitution, [](double) { return 0.1; }, 1);
  EXPECT_EQ(never.finding(), BoundaryFinding::below);
  EXPECT_EQ(always.finding(), BoundaryFinding::above);
  EXPECT_EQ(seldom.finding(), BoundaryFinding::below);
  EXPECT_LE(never.runs(), 40);
}

TEST(BoundarySearch, CrossingJustOutsideTheRangeIsNotClaimedToBeInside) {
  int claimed = 0;
  for (int number = 0; number < 50; ++number) {
    const auto search = searched(restitution, logistic(-0.02, 0.03), 500 + number);
    claimed += search.finding() == BoundaryFinding::crossing;
  }
  EXPECT_LE(claimed, 5);  // 1.25 of 50 and 3 standard errors of 1.1
}

TEST(BoundarySearch, EndsWithTheRunsItMayUse) {
  SearchRange range = restitution;
  range.most_runs = 21;
  const auto search = searched(range, logistic(0.5, 0.2), 1);
  EXPECT_EQ(search.runs(), 21);
  EXPECT_EQ(search.finding(), BoundaryFinding::unresolved);
  EXPECT_TRUE(search.has_ended());
}

TEST(BoundarySearch, FailedRunsAreUsedUpAndTeachNothing) {
  BoundarySearch search({.from = 0, .to = 1, .resolution = 0.1, .most_runs = 16});
  const auto first = search.next_round();
  for (int run = 0; run < 8; ++run) search.observe_failure();
  EXPECT_EQ(search.next_round().size(), 8U);
  EXPECT_EQ(search.finding(), BoundaryFinding::unresolved);
  for (int run = 0; run < 8; ++run) search.observe_failure();
  EXPECT_TRUE(search.next_round().empty());
}

TEST(BoundarySearch, CountsAreWholeNumbers) {
  const SearchRange range{
      .from = 10, .to = 40, .resolution = 3, .is_whole = true, .most_runs = 200};
  BoundarySearch search(range);
  for (auto round = search.next_round(); !round.empty(); round = search.next_round()) {
    for (const double x : round) {
      EXPECT_EQ(x, std::round(x));
      search.observe(x, x > 23.5);
    }
  }
  EXPECT_EQ(search.finding(), BoundaryFinding::crossing);
  EXPECT_NEAR(search.estimate().place, 23.5, 1.5);
}

TEST(BoundarySearch, PlacesAreDecimalsThatReadBack) {
  BoundarySearch search({.from = 0.1, .to = 0.7, .resolution = 0.02, .most_runs = 100});
  for (int round = 0; round < 3; ++round) {
    for (const double x : search.next_round()) {
      EXPECT_EQ(x, std::round(x * 1000) / 1000);
      search.observe(x, x < 0.35);
    }
  }
}

TEST(BoundarySearch, SameResultsGiveTheSameRounds) {
  const auto once = searched(restitution, logistic(0.3, 0.1), 9);
  const auto again = searched(restitution, logistic(0.3, 0.1), 9);
  EXPECT_EQ(once.runs(), again.runs());
  EXPECT_EQ(once.estimate().place, again.estimate().place);
}

TEST(BoundarySearch, FirstRoundDecidesNothing) {
  BoundarySearch search(restitution);
  for (const double x : search.next_round()) search.observe(x, false);
  EXPECT_EQ(search.finding(), BoundaryFinding::unresolved);
  for (const double x : search.next_round()) search.observe(x, false);
  EXPECT_EQ(search.finding(), BoundaryFinding::below);
}

TEST(BoundarySearch, IntervalLeavesAFortiethOnEitherSide) {
  // Before any run c is uniform in (-1, 2).
  const Estimate estimate = BoundarySearch(restitution).estimate();
  EXPECT_NEAR(estimate.place, 0.5, 1e-9);
  EXPECT_NEAR(estimate.low, -1 + 3 * 0.025, 1e-9);
  EXPECT_NEAR(estimate.high, 2 - 3 * 0.025, 1e-9);
}

TEST(Response, OneRunGivesTheWeightsThatBayesGives) {
  // c is uniform in (-1, 2), and a run at x = 0 met the criterion: if P rises, c is likely below 0,
  // a third of what is possible; if it falls, above, two thirds.
  Response response(0, 1, 0.01);
  response.observe(0, true);
  EXPECT_NEAR(response.rising(), 1.0 / 3,
              0.03);  // s blurs the edges of the prior by a few per cent
}

TEST(Response, QuantilesOfTheUniformPriorAreThoseOfTheUniform) {
  const Response response(2, 4, 0.1);
  EXPECT_NEAR(response.quantile(0.5), 3, 1e-9);
  EXPECT_NEAR(response.quantile(0.1), 0.6, 1e-9);  // from 0 to 6
}

}  // namespace
}  // namespace zenosphere
