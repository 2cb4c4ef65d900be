#include "flow/sonine.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace zenosphere {
namespace {

/// Velocities of a Gaussian, or uniform in a cube, with a common velocity.
template <class Distribution>
std::vector<Vec<3, double>> velocities(std::size_t spheres, Distribution component,
                                       std::mt19937_64& random) {
  std::vector<Vec<3, double>> result(spheres);
  for (auto& velocity : result) {
    for (double& number : velocity.components) number = 7 + component(random);
  }
  return result;
}

// <v^2> = 1, <v^4> = 1 of four unit vectors whose mean is 0: 3/5 x 11/9 - 1.
TEST(Sonine, OfFourEqualSpeedsIsKnownByHand) {
  const std::vector<Vec<3, double>> cross{{{1, 0, 0}}, {{-1, 0, 0}}, {{0, 1, 0}}, {{0, -1, 0}}};
  EXPECT_NEAR(second_sonine_coefficient<3>(cross), 3.0 / 5 * 11 / 9 - 1, 1e-15);
}

// 20000 samples of five spheres; a2 of one scatters by about 0.25.
TEST(Sonine, OfFewMaxwellianSpheresHasNoBias) {
  std::mt19937_64 random(1);
  double sum = 0, squares = 0;
  constexpr int samples = 20000;
  for (int n = 0; n < samples; ++n) {
    const double a2 =
        second_sonine_coefficient<3>(velocities(5, std::normal_distribution<>(), random));
    sum += a2 / samples;
    squares += a2 * a2 / samples;
  }
  EXPECT_LT(std::abs(sum), 5 * std::sqrt(squares / samples));
  EXPECT_LT(std::sqrt(squares / samples), 0.3);
}

// Uniform components in [-1, 1]: <v^2> = 1, <v^4> = 3/5 + 6/9, so a2 = 3/5 x 19/15 - 1 = -0.24.
TEST(Sonine, OfACubeIsKnown) {
  std::mt19937_64 random(1);
  const auto cube = velocities(400000, std::uniform_real_distribution<>(-1, 1), random);
  EXPECT_NEAR(second_sonine_coefficient<3>(cube), -0.24, 0.003);
}

TEST(Sonine, OfNothingThatMovesIsZero) {
  EXPECT_EQ(second_sonine_coefficient<2>(std::vector<Vec<2, double>>(3)), 0);
}

}  // namespace
}  // namespace zenosphere
