#include "engine/moving_walls.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace zenosphere {
namespace {

TEST(MovingWalls, HaveThePhaseOfTheWholeClock) {
  Walls<double> walls{.axis = 0};
  walls.oscillation.emplace(OscillationShape::sinusoidal, 1.0, 0.75);
  const MovingWalls<1, double> moving(walls, 1, 1.0);
  EXPECT_EQ(moving.phase({0, 0.5}), 0.5);
  EXPECT_EQ(moving.phase({0, 1}), 0.25);
  EXPECT_EQ(moving.phase({3, 0.25}), 0.25);      // 3 = 4 periods
  EXPECT_EQ(moving.phase({3e15 + 1, 0}), 0.25);  // no digit is lost in a long run
  EXPECT_EQ(moving.phase({3, -0.25}), 0.5);      // slightly in the past
}

TEST(ThermalVelocity, HasTheMomentsOfAGasThatLeaksThroughTheWall) {
  // Along the normal v exp(-m v^2/2T): mean sqrt(pi T/(2 m)), mean square 2 T/m. Across: T/m.
  for (const int side : {0, 1}) {
    Walls<double> walls{.axis = 2, .speed = {0.5, 0.5}, .temperature = {3.0, 3.0}, .seed = 9};
    MovingWalls<3, double> moving(walls, 1, 1.0);
    constexpr double mass = 2;
    constexpr int count = 200000;
    double mean = 0;
    double squares[3] = {0, 0, 0};
    double drift = 0;
    for (int n = 0; n < count; ++n) {
      const auto velocity = moving.thermal_velocity(walls, side, mass);
      EXPECT_GE(side == 0 ? velocity[2] : -velocity[2], 0);
      mean += std::abs(velocity[2]) / count;
      drift += velocity[0] / count;
      squares[0] += std::pow(velocity[0] - 0.5, 2) / count;
      squares[1] += std::pow(velocity[1], 2) / count;
      squares[2] += std::pow(velocity[2], 2) / count;
    }
    // Errors of 1 / sqrt(count) = 0.0022, relative to the root of the mean square.
    EXPECT_NEAR(mean, std::sqrt(std::numbers::pi * 3 / (2 * mass)), 5 * 0.0022 * 0.8);
    EXPECT_NEAR(drift, 0.5, 5 * 0.0022 * std::sqrt(1.5));
    EXPECT_NEAR(squares[0], 1.5, 5 * 0.0022 * 1.5 * std::sqrt(2));
    EXPECT_NEAR(squares[1], 1.5, 5 * 0.0022 * 1.5 * std::sqrt(2));
    EXPECT_NEAR(squares[2], 3, 5 * 0.0022 * 3);
  }
}

}  // namespace
}  // namespace zenosphere
