#include "flow/standard_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "model/random.hpp"

namespace zenosphere {
namespace {

/// A stationary series x' = memory x + a normal number: variance 1/(1 - memory^2) and, of the mean
/// of n, (1 + memory)/(1 - memory) times that over n, but for terms of order 1/n^2.
std::vector<double> autoregressive(double memory, std::size_t length, Random& random) {
  std::vector<double> series;
  double value = random.normal() / std::sqrt(1 - memory * memory);
  while (series.size() < length) {
    series.push_back(value);
    value = memory * value + random.normal();
  }
  return series;
}

struct Tally {
  double mean_square = 0;  ///< of the standard errors
  double covered = 0;      ///< share of the 95 % intervals that hold the true mean, 0
};

Tally tally(double memory, std::size_t length) {
  constexpr int series = 1000;
  Random random(7);
  Tally tally;
  for (int n = 0; n < series; ++n) {
    const MeasuredMean measured = measured_mean(autoregressive(memory, length, random));
    tally.mean_square += measured.standard_error * measured.standard_error / series;
    tally.covered +=
        (std::abs(measured.mean) < 1.96 * measured.standard_error ? 1.0 : 0.0) / series;
  }
  return tally;
}

// Of 1000 intervals 950 +- 7 hold the mean: 35 is 5 standard deviations. The error itself is known
// to sqrt((4 lag + 2) / n) each, about 20 %; its square to 40 %, over 1000 series to 1.3 %.
TEST(StandardError, IsThatOfIndependentValues) {
  const Tally seen = tally(0, 512);
  EXPECT_NEAR(seen.mean_square * 512, 1, 0.07);
  EXPECT_NEAR(seen.covered, 0.95, 0.035);
}

TEST(StandardError, OfNumbersThatAlternateIsWorkedOutByHand) {
  // 64 deviations of -1 and 1: their variance is 64/63. Half the sum of correlations up to the lag
  // 2 = 4 x 1/2 is below 1/2, so that tau is 1/2, with 1 + 5/64 for the bias of a short series.
  std::vector<double> values(64);
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = k % 2 == 0 ? 3 : 5;
  const MeasuredMean measured = measured_mean(values);
  EXPECT_EQ(measured.mean, 4);
  EXPECT_NEAR(measured.standard_error, std::sqrt(69.0 / (63 * 64)), 1e-15);
}

TEST(StandardError, GrowsByTheKnownFactorWhereValuesRemember) {
  const Tally seen = tally(0.8, 1024);
  const double exact = 1.8 / 0.2 / (1 - 0.64) / 1024;
  EXPECT_NEAR(seen.mean_square / exact, 1, 0.07);
  EXPECT_NEAR(seen.covered, 0.95, 0.035);
}

TEST(StandardError, CountsTheIndependentValues) {
  Random random(3);
  const MeasuredMean measured = measured_mean(autoregressive(0.5, 100'000, random));
  EXPECT_NEAR(measured.independent * 3 / 100'000, 1, 0.05);  // (1 + 0.5)/(1 - 0.5) = 3
}

TEST(StandardError, IsUnknownOfAShortSeries) {
  Random random(3);
  EXPECT_TRUE(std::isnan(measured_mean(autoregressive(0, 15, random)).standard_error));
  EXPECT_TRUE(std::isnan(measured_mean(autoregressive(0.99, 200, random)).standard_error));
  EXPECT_TRUE(std::isnan(measured_mean({}).mean));
  EXPECT_TRUE(std::isnan(measured_mean(std::vector<double>{1}).standard_error));
}

TEST(StandardError, IsNoneOfANumberThatIsConserved) {
  std::vector<double> values(100, 2.5);
  values[50] += 1e-13;
  EXPECT_EQ(measured_mean(values).standard_error, 0);
  EXPECT_NEAR(measured_mean(values).mean, 2.5, 1e-13);
}

}  // namespace
}  // namespace zenosphere
