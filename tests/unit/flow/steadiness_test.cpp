#include "flow/steadiness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "flow/reliability.hpp"
#include "model/random.hpp"

namespace zenosphere {
namespace {

constexpr Inertia thousand{1000, 1};

Observables observables(double temperature, const std::vector<double>& streaks) {
  Observables result;
  result.granular_temperature = temperature;
  result.temperature_diagonal = {temperature, temperature, temperature};
  result.pressure_tensor.assign(9, 1.0);
  result.collision_rate = 5;
  result.streak_modes = streaks;
  return result;
}

/// A run of so many intervals of length 1 whose temperature is `temperature(time)`.
Averages averages_of(std::size_t intervals, const std::function<double(double)>& temperature,
                     const std::vector<double>& streaks = {}) {
  ObservableSeries series(observables(0, streaks), 1, 1000);
  for (std::size_t k = 0; k < intervals; ++k) {
    const auto time = static_cast<double>(k);
    series.add(observables(temperature(time), streaks), static_cast<std::int64_t>(100'000 * k));
  }
  Averages averages{series.mean(0, {}, 0)};
  averages.to_time = series.end();
  add_reliability(averages, series, thousand);
  return averages;
}

std::function<double(double)> noise(std::uint64_t seed) {
  return [random = Random(seed)](double) mutable { return 1 + 0.1 * random.normal(); };
}

TEST(Steadiness, NoiseIsSteadyAndHasItsError) {
  const Averages averages = averages_of(100, noise(1));
  EXPECT_EQ(averages.steady, true) << averages.steady_reason;
  EXPECT_NEAR(averages.standard_error->granular_temperature, 0.01, 0.004);  // 0.1 / sqrt(100)
  EXPECT_GT(averages.blocks.value(), 50);
}

TEST(Steadiness, ConservedEnergyIsSteadyWithoutError) {
  const Averages averages = averages_of(100, [](double) { return 1.5; });
  EXPECT_EQ(averages.steady, true);
  EXPECT_EQ(averages.standard_error->granular_temperature, 0);
}

// The mean of 1/k^2 for k = 1 to 20 is 1.5962 / 20, for k = 81 to 100 it is 0.0024722 / 20.
TEST(Steadiness, CoolingIsNotSteadyHoweverItSlowsDown) {
  const Averages averages = averages_of(100, [](double t) { return std::pow(1 + t, -2); });
  EXPECT_EQ(averages.steady, false);
  EXPECT_EQ(averages.steady_reason,
            "not steady: granular temperature falls from 0.07981 to 0.0001236 from time 0 to 100");
}

// Of the first 100 / 16 = 6 intervals two are at 11: (2 x 11 + 4) / 6 = 4.33.
TEST(Steadiness, ABurstAtTheStartIsNoSteadyState) {
  const auto quiet = noise(3);
  const auto burst = [quiet](double t) mutable { return quiet(t) + (t < 2 ? 10 : 0); };
  const Averages averages = averages_of(100, burst);
  EXPECT_EQ(averages.steady, false);
  EXPECT_NE(averages.steady_reason.find("granular temperature begins at 4.3"), std::string::npos)
      << averages.steady_reason;
}

TEST(Steadiness, ABurstThatComesBackIsPartOfTheState) {
  const auto quiet = noise(4);
  const auto bursts = [quiet](double t) mutable {
    return quiet(t) + (std::fmod(t, 12) < 2 ? 10 : 0);
  };
  EXPECT_EQ(averages_of(100, bursts).steady, true) << averages_of(100, bursts).steady_reason;
}

TEST(Steadiness, TheBeginningOfACorrelatedSeriesIsSeldomTakenForATransient) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    Random random(seed);
    double state = 3 * random.normal();  // remembers for 10 intervals, of a run of 160
    const auto correlated = [&](double) { return 10 + (state = 0.9 * state + random.normal()); };
    const Averages averages = averages_of(160, correlated);
    EXPECT_EQ(averages.steady_reason.find("begins"), std::string::npos) << averages.steady_reason;
  }
}

TEST(Steadiness, ATrendBeyondTheNoiseIsADrift) {
  const auto quiet = noise(2);
  const auto drifting = [quiet](double t) mutable { return quiet(t) + 0.003 * t; };
  const Averages averages = averages_of(100, drifting);
  EXPECT_EQ(averages.steady, false);
  EXPECT_NE(averages.steady_reason.find("rises"), std::string::npos) << averages.steady_reason;
}

TEST(Steadiness, ANormalStressDifferenceThatDriftsIsNamed) {
  Observables flow = observables(1, {});
  flow.pressure = 1;
  flow.normal_stress_differences = {0.1, 0.0};
  ObservableSeries series(flow, 1, 1000);
  for (std::int64_t k = 0; k < 100; ++k) {
    flow.normal_stress_differences[1] = 0.001 * static_cast<double>(k);
    series.add(flow, 100'000 * k);
  }
  Averages averages{series.mean(0, {}, 0)};
  add_reliability(averages, series, thousand);
  EXPECT_EQ(averages.steady, false);
  EXPECT_NE(averages.steady_reason.find("normal stress difference N2 rises from 0.0095 to 0.0895"),
            std::string::npos)
      << averages.steady_reason;
}

TEST(Steadiness, AFewIntervalsTellNothing) {
  const Averages averages = averages_of(15, noise(3));
  EXPECT_FALSE(averages.steady.has_value());
  EXPECT_NE(averages.steady_reason.find("too short"), std::string::npos);
}

// A^2/2 = 0.125 of a temperature of 1; a mode has the thermal energy A^2 = 4/1000.
TEST(Steadiness, AStreakThatInflatesTheTemperatureIsTakenOut) {
  const Averages averages = averages_of(100, noise(4), {0, 0, 0.5, 0});
  EXPECT_EQ(averages.steady, false);
  EXPECT_DOUBLE_EQ(averages.streak_amplitude.value(), 0.5);
  const double thermal = 4 * 2 * averages.temperature_diagonal[0] / 1000;
  EXPECT_NEAR(averages.temperature_without_streak.value(),
              averages.granular_temperature - (0.125 - thermal) / 3, 1e-12);
  EXPECT_NE(averages.steady_reason.find("a streak along the flow carries 12 % of T_xx"),
            std::string::npos)
      << averages.steady_reason;
}

TEST(Steadiness, ThermalWavesAreNoStreak) {
  EXPECT_EQ(averages_of(100, noise(5), {0.06, 0.06, 0.06, 0.06}).steady, true);
}

}  // namespace
}  // namespace zenosphere
