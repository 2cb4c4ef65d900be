#include "flow/trend.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "model/random.hpp"

namespace zenosphere {
namespace {

std::vector<double> noise(std::size_t length, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> values(length);
  for (double& value : values) value = random.normal();
  return values;
}

TEST(Trend, OfALineIsThatLine) {
  const Trend line = trend(std::vector<double>{1, 3, 5, 7});
  EXPECT_DOUBLE_EQ(line.change, 8);
  EXPECT_NEAR(line.error, 0, 1e-12);
  EXPECT_DOUBLE_EQ(line.explained, 1);
}

// The change along a line through n values of variance 1 has the variance 12 / n.
TEST(Trend, OfNoiseIsWithinItsError) {
  int beyond = 0;
  double squares = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const Trend line = trend(noise(200, seed));
    squares += line.error * line.error / 400;
    beyond += std::abs(line.change) > 2 * line.error;
  }
  EXPECT_NEAR(squares / (12 / 200.0), 1, 0.1);
  EXPECT_NEAR(beyond, 18, 18);  // of 400, 4.6 % are; 4 standard deviations
}

TEST(Trend, OfRanksSeesAnyOneWayChange) {
  std::vector<double> decay;
  for (int k = 0; k < 50; ++k) decay.push_back(1 / std::pow(1.0 + k, 2));
  EXPECT_LT(trend(decay).explained, 0.3);
  EXPECT_DOUBLE_EQ(trend(ranks(decay)).explained, 1);
  EXPECT_LT(trend(ranks(decay)).change, 0);
  EXPECT_EQ(ranks(std::vector<double>{5, -1, 7}), (std::vector<double>{1, 0, 2}));
}

TEST(Transient, EndsWhereTheSeriesBecomesStationary) {
  auto values = noise(400, 5);
  for (std::size_t k = 0; k < 100; ++k) values[k] += 20 * std::exp(-static_cast<double>(k) / 20);
  // The transient is 20 exp(-k/20): 1.6 of the noise at k = 50, and 0.13 of it at k = 100.
  EXPECT_GE(transient_length(values), 50u);
  EXPECT_LE(transient_length(values), 150u);
}

TEST(Transient, OfAStationarySeriesIsShort) {
  int dropped = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    dropped += static_cast<int>(transient_length(noise(400, seed)));
  }
  EXPECT_LT(dropped / 100, 40);
}

TEST(Transient, IsAtMostHalfOfTheSeries) {
  std::vector<double> values;
  for (int k = 0; k < 200; ++k) values.push_back(k);
  EXPECT_EQ(transient_length(values), 100u);
}

}  // namespace
}  // namespace zenosphere
