#include "model/oscillation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "model/real.hpp"

namespace zenosphere {
namespace {

constexpr auto sinusoidal = OscillationShape::sinusoidal;
constexpr auto parabolic = OscillationShape::parabolic;

TEST(Pi, HasAllDigitsOfEveryPrecision) {
  EXPECT_NEAR(pi<double>(), std::numbers::pi, 1e-15);
  EXPECT_LT(abs(pi<Quad>() - Quad("3.14159265358979323846264338327950288419717")), Quad("1e-32"));
  const Digits known(
      "3."
      "14159265358979323846264338327950288419716939937510582097494459230781640628620899862803482");
  EXPECT_LT(abs(pi<Digits>() - known), Digits("1e-88"));
}

TEST(AfterWholePeriods, IsTheExactRemainder) {
  for (const double period : {0.1, 0.3, 1.0, 7.25, 1e-3}) {
    for (const double x : {0.0, 0.05, 0.1, 5.0, 1e6, 123456789.0, 1e15}) {
      EXPECT_EQ(after_whole_periods(x, period), std::fmod(x, period)) << x << " " << period;
    }
  }
}

TEST(Oscillation, BeginsAtItsLowestPlaceAtRest) {
  for (const auto shape : {sinusoidal, parabolic}) {
    const Oscillation<double> wall(shape, 0.5, 2);
    EXPECT_EQ(wall.at(0).height, 0);
    EXPECT_EQ(wall.at(0).speed, 0);
    EXPECT_NEAR(wall.at(0).acceleration, wall.peak_acceleration(), 1e-15);
    EXPECT_NEAR(wall.at(1).height, 1, 1e-15);  // twice the amplitude, half a period later
    EXPECT_NEAR(wall.at(1).speed, 0, 1e-15);
    EXPECT_NEAR(wall.at(0.5).height, 0.5, 1e-15);  // at its middle it is fastest
  }
}

TEST(Oscillation, OfASineIsThatOfTheLibrary) {
  const Oscillation<double> wall(sinusoidal, 0.3, 0.7);
  const double turning = 2 * std::numbers::pi / 0.7;
  for (double phase = 0; phase < 0.7; phase += 0.0123) {
    const auto state = wall.at(phase);
    EXPECT_NEAR(state.height, 0.3 * (1 - std::cos(turning * phase)), 1e-15);
    EXPECT_NEAR(state.speed, 0.3 * turning * std::sin(turning * phase), 1e-14);
    EXPECT_NEAR(state.acceleration, 0.3 * turning * turning * std::cos(turning * phase), 1e-13);
  }
}

TEST(Oscillation, OfParabolasHasAConstantAccelerationInEachPiece) {
  // Amplitude 2, period 4: 32 x 2 / 16 = 4 upwards for 1, downwards for 2, upwards for 1.
  const Oscillation<double> wall(parabolic, 2, 4);
  EXPECT_EQ(wall.at(0.5).acceleration, 4);
  EXPECT_EQ(wall.at(0.5).height, 0.5);
  EXPECT_EQ(wall.at(1).height, 2);
  EXPECT_EQ(wall.at(1).speed, 4);
  EXPECT_EQ(wall.at(1.5).acceleration, -4);
  EXPECT_EQ(wall.at(1.5).height, 3.5);
  EXPECT_EQ(wall.at(2).height, 4);
  EXPECT_EQ(wall.at(3).speed, -4);
  EXPECT_EQ(wall.at(3.5).acceleration, 4);
  EXPECT_EQ(wall.at(3.5).height, 0.5);
}

template <class Real>
void expect_deviations(OscillationShape shape) {
  const Oscillation<Real> wall(shape, Real(0.25), Real(1.5));
  for (const double phase : {0.0, 0.1, 0.37, 0.375, 0.9, 1.1, 1.3}) {
    for (const double span : {-2.1, -0.2, 1e-3, 0.2, 0.7, 1.4, 3.3}) {
      const Real then = after_whole_periods(Real(phase + span + 3), Real(1.5));
      const auto at_first = wall.at(Real(phase));
      const auto later = wall.at(then);
      const auto [deviation, acceleration] = wall.later(wall.origin(Real(phase)), Real(span));
      // Phases of double numbers: 3 is rounded once, the sums a few times.
      EXPECT_LT(abs(deviation.height - (later.height - at_first.height - at_first.speed * span)),
                Real(1e-14));
      EXPECT_LT(abs(deviation.speed - (later.speed - at_first.speed)), Real(2e-14));
    }
  }
}
TEST(Deviation, IsWhatIsLeftOfAWayWithoutItsTangent) {
  using std::abs;
  for (const auto shape : {sinusoidal, parabolic}) {
    expect_deviations<Quad>(shape);
    expect_deviations<Digits>(shape);
  }
}

TEST(Deviation, KeepsItsDigitsInTheShortestTime) {
  // a t^2/2 + (da/dt) t^3/6 + ...: at t = 1e-9 the difference of two heights would have lost all.
  const Oscillation<double> wall(sinusoidal, 1, 2 * std::numbers::pi);
  for (const double phase : {0.1, 1.0, 2.0, 4.0}) {
    const double t = 1e-9;
    const auto deviation = wall.later(wall.origin(phase), t).deviation;
    const double a = std::cos(phase);
    const double jerk = -std::sin(phase);
    EXPECT_NEAR(deviation.height / (a * t * t / 2 + jerk * t * t * t / 6), 1, 1e-14);
    EXPECT_NEAR(deviation.speed / (a * t + jerk * t * t / 2), 1, 1e-14);
  }
}

}  // namespace
}  // namespace zenosphere
