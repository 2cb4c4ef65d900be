#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "run/setup.hpp"
#include "support/run_text.hpp"

namespace zenosphere {
namespace {

/// An elastic gas between two thermal walls.
std::string gas(int dimension, double lower, double upper, const std::string& more = "") {
  const std::string sides[] = {"40", "8, 12", "5, 5, 10"};
  const char* const axes[] = {"x", "y", "z"};
  return fmt::format(R"(
[system]
dimension = {}
spheres = {}
restitution = 1
sides = [{}]
[start]
arrangement = "random"
granular_temperature = 1
seed = 3
[drive]
kind = "none"
[walls]
axis = "{}"
restitution = 1
lower_temperature = {}
upper_temperature = {}
[run]
collisions = 200000
[measure]
after_time = 60
{}
)",
                     dimension, dimension == 1 ? 10 : 40, sides[dimension - 1], axes[dimension - 1],
                     lower, upper, more);
}

TEST(ThermalWalls, OfEqualTemperatureGiveItToTheGas) {
  for (const int dimension : {1, 2, 3}) {
    const Summary run = test::run_text(gas(dimension, 1.7, 1.7));
    ASSERT_TRUE(run.averages && run.averages->standard_error) << dimension;
    const auto& averages = *run.averages;
    EXPECT_NEAR(averages.granular_temperature, 1.7,
                5 * averages.standard_error->granular_temperature)
        << dimension;
    EXPECT_LT(averages.standard_error->granular_temperature, 0.03) << dimension;
    // In equilibrium no heat flows: both walls together and each for itself.
    for (const std::size_t wall : {0, 1}) {
      EXPECT_NEAR(averages.wall_work[wall], 0, 5 * averages.standard_error->wall_work[wall]);
    }
    EXPECT_LT(run.ledger_error, 1e-11) << dimension;
    EXPECT_FALSE(run.self_check) << dimension;
  }
}

// Of Maxwell's distribution <v^4> = 3 <v^2>^2 in each component, <v^2> = T for a unit mass.
TEST(ThermalWalls, GiveTheGasMaxwellsVelocities) {
  auto simulation = new_simulation<2, double>(parse_case(gas(2, 2, 2), "test.toml", {}));
  double squares[2] = {0, 0};
  double fourths[2] = {0, 0};
  int count = 0;
  for (double time = 50; time < 3000; time += 1) {
    while (!simulation.has_reached(time)) simulation.next_collision(time);
    for (const auto& velocity : simulation.configuration().velocities) {
      for (int axis = 0; axis < 2; ++axis) {
        squares[axis] += std::pow(velocity[axis], 2);
        fourths[axis] += std::pow(velocity[axis], 4);
      }
      ++count;
    }
  }
  // 1.2e5 values, correlated over some time units: about 1 % of each moment.
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_NEAR(squares[axis] / count, 2, 0.05) << axis;
    EXPECT_NEAR(fourths[axis] / count / std::pow(squares[axis] / count, 2), 3, 0.1) << axis;
  }
}

TEST(ThermalWalls, OfDifferentTemperaturesLeadHeatThroughTheGas) {
  for (const int dimension : {2, 3}) {
    const Summary run = test::run_text(gas(dimension, 3, 1));
    ASSERT_TRUE(run.averages && run.averages->standard_error) << dimension;
    const auto& averages = *run.averages;
    const auto& errors = *averages.standard_error;
    EXPECT_GT(averages.wall_work[0], 10 * errors.wall_work[0]) << dimension;
    EXPECT_LT(averages.wall_work[1], -10 * errors.wall_work[1]) << dimension;
    EXPECT_NEAR(averages.wall_work[0] + averages.wall_work[1], 0,
                5 * std::hypot(errors.wall_work[0], errors.wall_work[1]))
        << dimension;
    EXPECT_GT(averages.granular_temperature, 1) << dimension;
    EXPECT_LT(averages.granular_temperature, 3) << dimension;
    EXPECT_LT(run.ledger_error, 1e-11) << dimension;
    EXPECT_EQ(averages.dissipation, 0) << dimension;
  }
}

// The velocity that it gives is not a small difference of large ones: a sphere that came with 1 is
// let go with about 1e-20, and not at rest.
TEST(ThermalWalls, LetGoWhatIsMuchFasterThanTheyAre) {
  std::string text = gas(2, 2, 1e-40);
  text.erase(text.find("granular_temperature = 1\n"), 25);
  const std::vector<std::string> one{"system.spheres=1", "start.arrangement=given",
                                     "start.positions=[[4, 4]]", "start.velocities=[[0, 1]]"};
  auto simulation = new_simulation<2, double>(parse_case(text, "test.toml", one));
  ASSERT_TRUE(simulation.next_collision(10));
  const auto velocity = simulation.peculiar_velocity(0);
  EXPECT_LT(velocity[1], 0);
  EXPECT_GT(velocity[1], -1e-18);
}

TEST(ThermalWalls, DrawTheSameVelocitiesFromTheSameSeed) {
  const std::vector<std::string> few{"run.collisions=3000", "measure.after_time=0"};
  const Summary one = test::run_text(gas(2, 2, 1), few);
  const Summary same = test::run_text(gas(2, 2, 1), few);
  EXPECT_EQ(one.time, same.time);
  EXPECT_EQ(one.averages->wall_work[0], same.averages->wall_work[0]);
  auto other = few;
  other.emplace_back("start.seed=4");
  EXPECT_NE(test::run_text(gas(2, 2, 1), other).time, one.time);
}

TEST(ThermalWalls, HeatAnInelasticGasToASteadyState) {
  const Summary run = test::run_text(gas(3, 1, 1), {"system.restitution=0.95"});
  const auto& averages = *run.averages;
  const auto& errors = *averages.standard_error;
  // What comes in through both walls is lost in the volume between them, 10 high.
  EXPECT_NEAR((averages.wall_work[0] + averages.wall_work[1]) / 10, averages.dissipation,
              5 * std::hypot(errors.wall_work[0], errors.wall_work[1], errors.dissipation));
  EXPECT_LT(averages.granular_temperature, 1);
  EXPECT_LT(run.ledger_error, 1e-11);
}

}  // namespace
}  // namespace zenosphere
