#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <ostream>
#include <string>

#include "support/run_text.hpp"

namespace zenosphere {
namespace {

const char* const driven_gas_case = R"(
[system]
dimension = 2
spheres = 1000
restitution = 0.95
solids_volume_fraction = 0.3
[start]
arrangement = "random"
granular_temperature = 1
[drive]
kind = "random"
noise_strength = 0.1
kick_interval = 0.05
[run]
time = 100
[measure]
after_time = 40
)";

struct Driven {
  int dimension;
  double restitution;
  double time;

  friend void PrintTo(const Driven& driven, std::ostream* out) { *out << driven.restitution; }
};

/// Collisions per sphere and time at T = 1, from Enskog with the equations of state of Tonks,
/// Henderson and Kolafa et al. at a solids volume fraction of 0.3.
double collision_rate(int dimension) {
  const double root_pi = std::sqrt(std::numbers::pi);
  if (dimension == 1) return 2 * 0.3 / 0.7 / root_pi;
  if (dimension == 2)
    return 2 * (4 * 0.3 / std::numbers::pi) * (1.01125 / 0.49 - 1) / 0.6 * root_pi;
  return 4 * (6 * 0.3 / std::numbers::pi) * (3.984 - 1) / 1.2 * root_pi;
}

class RandomDrivingIn : public testing::TestWithParam<Driven> {};

TEST_P(RandomDrivingIn, FeedsWhatTheCollisionsTake) {
  const auto& [dimension, e, time] = GetParam();
  const double noise = (1 - e * e) * collision_rate(dimension) / dimension;
  const Summary run = test::run_text(
      driven_gas_case,
      {"system.dimension=" + std::to_string(dimension), "system.restitution=" + std::to_string(e),
       "drive.noise_strength=" + std::to_string(noise), "run.time=" + std::to_string(time)});
  ASSERT_TRUE(run.averages);
  const Averages& averages = *run.averages;
  const double densities[] = {0.3, 4 * 0.3 / std::numbers::pi, 6 * 0.3 / std::numbers::pi};
  const double density = densities[dimension - 1];
  // Every component gains noise_strength per time, less the mean that is removed.
  const double input = density * dimension * noise / 2 * (1 - 1.0 / 1000);
  // The work also has the sum of v.change over all kicks, of zero mean and variance N D T times the
  // noise: relative to N D noise time/2 that is 2 sqrt(T/(N D noise time)).
  const double span = averages.to_time - averages.from_time;
  const double scatter = 2 / std::sqrt(1000 * dimension * noise * span);
  EXPECT_NEAR(averages.other_work, input, 5 * scatter * input);
  // The stored energy, N D T/2, stays but for some per cent of itself: fluctuations and a start
  // that is not quite steady.
  const double stored = density * dimension / 2 * 0.1 / span;
  EXPECT_NEAR(averages.dissipation, averages.other_work, stored);
  // Balance: D noise/2 = (omega/2)(1 - e^2) T with omega growing as sqrt(T); noise is such that T
  // is 1 but for the momentum removed. Sonine corrections are below 2 % (van Noije & Ernst,
  // Granular Matter 1 (1998) 57), fluctuations of the mean as large in 1-D.
  const double temperature =
      std::pow(dimension * noise * 0.999 / ((1 - e * e) * collision_rate(dimension)), 2.0 / 3);
  EXPECT_NEAR(averages.granular_temperature, temperature, 0.05 * temperature);
  EXPECT_LT(run.ledger_error, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, RandomDrivingIn,
                         testing::Values(Driven{1, 0.98, 400}, Driven{2, 0.95, 100},
                                         Driven{3, 0.95, 60}),
                         [](const auto& driven) {
                           return "dimension_" + std::to_string(driven.param.dimension);
                         });

}  // namespace
}  // namespace zenosphere
