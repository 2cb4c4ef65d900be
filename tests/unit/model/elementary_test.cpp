#include "model/elementary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "model/real.hpp"

namespace zenosphere {
namespace {

template <class Real>
void expect_fifth_roots() {
  const Real eps = std::numeric_limits<Real>::epsilon();
  EXPECT_EQ(fifth_root(Real(0)), 0);
  for (const double x : {1e-300, 1e-16, 0.03125, 0.7, 1.0, 32.0, 243.0, 1e10, 1e300}) {
    const Real root = fifth_root(Real(x));
    const Real back = root * root * root * root * root;
    // Two ulps of the root are ten of its fifth power, and the product rounds four times.
    EXPECT_LT(back, Real(x) * (1 + 14 * eps)) << x;
    EXPECT_GT(back, Real(x) * (1 - 14 * eps)) << x;
  }
  EXPECT_EQ(fifth_root(Real(32)), 2);
}

TEST(FifthRoot, IsGoodToTwoUlpsInEveryPrecisionAndRange) {
  expect_fifth_roots<double>();
  expect_fifth_roots<Extended>();
  expect_fifth_roots<Quad>();
  expect_fifth_roots<Digits>();
}

TEST(SineAndCosine, AreThoseOfTheCLibrary) {
  for (const double angle : {-1.57, -0.5, -1e-3, 0.0, 1e-9, 0.1, 1.0, 1.57}) {
    const auto [sine, cosine] = sine_and_cosine(angle);
    // The largest term of the series is 1.57; each of the twenty rounds by half an ulp.
    EXPECT_NEAR(sine, std::sin(angle), 4e-16) << angle;
    EXPECT_NEAR(cosine, std::cos(angle), 4e-16) << angle;
  }
}

TEST(SineAndCosine, KeepTheLengthInEveryPrecision) {
  const auto [sine, cosine] = sine_and_cosine(Digits(1));
  const Digits error = sine * sine + cosine * cosine - 1;
  EXPECT_LT(abs(error), Digits("1e-99"));
  // sin(1) = 0.84147098480789650665250232163029899962...
  EXPECT_LT(abs(sine - Digits("0.84147098480789650665250232163029899962")), Digits("1e-37"));
}

TEST(Elementary, ExponentialAgreesWithTheLibraryToAFewUlps) {
  for (double x = -680; x < 690; x += 0.7531) {
    EXPECT_NEAR(portable_exp(x) / std::exp(x), 1, 4 * std::numeric_limits<double>::epsilon()) << x;
  }
  EXPECT_EQ(portable_exp(0), 1);
  EXPECT_EQ(portable_exp(-1000), 0);
}

}  // namespace
}  // namespace zenosphere
