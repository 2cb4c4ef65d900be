#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "engine/start.hpp"
#include "flow/measurements.hpp"
#include "support/run_text.hpp"

namespace zenosphere {
namespace {

const char* const elastic_disks_case = R"(
[system]
dimension = 2
spheres = 1000
restitution = 1
solids_volume_fraction = 0.3
[start]
arrangement = "random"
granular_temperature = 1
[drive]
kind = "none"
[run]
collisions = 150000
[measure]
after_time = 5
)";

// 300 collisions per disk: seeds scatter by 0.2 %, so that 1 % is 5 standard errors.
TEST(ElasticDisks, PressureAndCollisionRateAreThoseOfTheHardDiskFluid) {
  const Summary run = test::run_text(elastic_disks_case);
  ASSERT_TRUE(run.averages);
  // Henderson, Mol. Phys. 30 (1975) 971, at phi = 0.3: 1.01125/0.49 = 2.0638.
  const double phi = 0.3;
  const double z = (1 + phi * phi / 8) / ((1 - phi) * (1 - phi));
  EXPECT_NEAR(run.averages->compressibility_factor, z, 0.01 * z);
  // Around a disk lie 2 pi n g places of contact per area, each approached at the mean flux
  // sqrt(T/pi) of relative speeds with variance 2 T: 2 n g sqrt(pi T), with g = (Z - 1)/(2 phi)
  // from the virial and n = 4 phi/pi: 2.400.
  const double g = (z - 1) / (2 * phi);
  const double rate = 2 * (4 * phi / std::numbers::pi) * g * std::sqrt(std::numbers::pi);
  EXPECT_NEAR(run.averages->collision_rate, rate, 0.01 * rate);
  // As in every dimension closing speeds are distributed as v exp(-v^2/4).
  EXPECT_NEAR(run.averages->normal_speed, std::sqrt(std::numbers::pi), 0.01 * 1.772);
  EXPECT_NEAR(run.averages->granular_temperature, 1, 1e-12);
  EXPECT_LT(run.ledger_error, 1e-12);
}

/// Sums of |v_i - v_j| and (v_i - v_j)^2 over all pairs.
struct PairSums {
  double speed = 0;
  double square = 0;
};
PairSums pair_sums(const std::vector<Vec<1, double>>& velocities) {
  PairSums sums;
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double speed = std::abs(velocities[i][0] - velocities[j][0]);
      sums.speed += speed;
      sums.square += speed * speed;
    }
  }
  return sums;
}

struct Rods {
  int count = 200;
  double side = 500;  // a line fraction of 0.4
  double time = 5000;
};

Averages averages_of(const Rods& rods, const ShearBox<1, double>& box,
                     const Configuration<1, double>& start,
                     const Surroundings<1, double>& surroundings) {
  Simulation<1, double> gas(box, start, {1.0}, surroundings);
  Measurements<1, double> measurements(gas, 0);
  while (!gas.has_reached(rods.time)) {
    if (const auto collision = gas.next_collision(rods.time)) measurements.observe(*collision, gas);
  }
  EXPECT_LT(measurements.ledger_error(gas), 1e-12);
  return measurements.averages(gas).value();
}

// Elastic rods exchange their velocities: each velocity runs around a ring of length L - N as if
// it were alone (Jepsen, J. Math. Phys. 6 (1965) 405), and two of them meet at |v_i - v_j|/(L - N)
// per time. So over a time t the number of meetings of each pair is known but for one, and
//   P L = N T + sum of (v_i - v_j)^2/(L - N) = N T + N^2 T/(L - N),
// which is Tonks' Z = 1/(1 - phi) (Phys. Rev. 50 (1936) 936) for every N.
TEST(ElasticRods, PressureAndCollisionRateAreThoseOfTonks) {
  const Rods rods;
  const ShearBox<1, double> box({rods.side}, 0);
  const auto start = make_start<1>({Arrangement::random, rods.count, 1, 3}, box);
  const Averages averages = averages_of(rods, box, start, {});
  const PairSums sums = pair_sums(start.velocities);
  const double room = rods.side - rods.count;
  // 19900 pairs, each count wrong by less than one, at random: 19900^(1/2) of 1.5e7 in all.
  const double collisions = sums.speed / room * rods.time;
  EXPECT_NEAR(averages.collision_rate, 2 * collisions / (rods.count * rods.time),
              1e-4 * averages.collision_rate);
  const double z = 1 / (1 - rods.count / rods.side);
  EXPECT_NEAR(averages.compressibility_factor, z, 1e-3 * z);
  // For Gaussian velocities the rate is 2 n g sqrt(T/pi), g = 1/(1 - phi): two ends, each
  // approached at the flux sqrt(T/pi). The mean of |v_i - v_j| at a given variance scatters by
  // 0.1/sqrt(N) = 0.7 %.
  const double rate = 2 * (rods.count / rods.side) * z / std::sqrt(std::numbers::pi);
  EXPECT_NEAR(averages.collision_rate, rate, 0.03 * rate);
}

// Between walls each velocity alone runs to and fro over L - N and gives 2 |v| to a wall each time
// it comes back: the pressure of N rods is N T/(L - N) on both walls, for every N.
TEST(ElasticRodsBetweenWalls, PressOnBothWallsAsTonksSays) {
  const Rods rods;
  const ShearBox<1, double> box({rods.side}, 0, 1.5, 0);
  const auto start = make_start<1>({Arrangement::random, rods.count, 1, 3}, box);
  const Averages averages = averages_of(rods, box, start, {{}, Walls<double>{.axis = 0}});
  const double pressure = rods.count / (rods.side - rods.count);
  ASSERT_EQ(averages.wall_pressure.size(), 2U);
  // A velocity of 1 comes to a wall 8 times in the time; wrong by up to one half each way at
  // random: (1/2)/(8 sqrt(200)) = 0.4 %.
  EXPECT_NEAR(averages.wall_pressure[0], pressure, 0.02 * pressure);
  EXPECT_NEAR(averages.wall_pressure[1], pressure, 0.02 * pressure);
  EXPECT_NEAR(averages.pressure, pressure, 0.02 * pressure);
}

struct Walled {
  int dimension;
  std::string axis;
  int normal;

  friend void PrintTo(const Walled& walled, std::ostream* out) { *out << walled.axis; }
};

class GasBetweenWalls : public testing::TestWithParam<Walled> {};

// The virial theorem: d/dt sum m x v_x = 2 K_x + pair virial - (walls), x from the middle. So the
// pressure on the walls is the mean normal pressure but for the change of sum x v_x, which is of
// the order sqrt(N T) L/sqrt(12) at both ends of the run: divided by the volume, the time and the
// pressure that is the relative difference; five of them are allowed.
TEST_P(GasBetweenWalls, PressesOnThemAsItDoesInside) {
  const auto& [dimension, axis, normal] = GetParam();
  const int spheres = 500;
  const Summary run = test::run_text(
      elastic_disks_case, {"system.dimension=" + std::to_string(dimension),
                           "system.spheres=" + std::to_string(spheres), "walls.axis=" + axis,
                           "walls.restitution=1", "measure.after_time=0", "run.collisions=100000"});
  ASSERT_TRUE(run.averages);
  const Averages& averages = *run.averages;
  ASSERT_EQ(averages.wall_pressure.size(), 2U);
  const double volume = spheres / (6 * 0.3 / std::numbers::pi);
  const double density_volume = dimension == 2 ? spheres / (4 * 0.3 / std::numbers::pi) : volume;
  const double side = std::pow(density_volume, 1.0 / dimension);
  const double virial = std::sqrt(spheres / 12.0) * side * std::sqrt(2.0);
  const double tolerance = 5 * virial / (density_volume * run.time);
  const double inside =
      averages.pressure_tensor[static_cast<std::size_t>(normal * dimension + normal)];
  const double outside = (averages.wall_pressure[0] + averages.wall_pressure[1]) / 2;
  EXPECT_NEAR(outside, inside, tolerance);
  // What both walls give more to one side is momentum that the gas has gained: sqrt(N T) at most
  // some times, over the area and the time.
  const double area = density_volume / side;
  EXPECT_NEAR(averages.wall_pressure[0], averages.wall_pressure[1],
              5 * std::sqrt(2.0 * spheres) / (area * run.time));
  EXPECT_LT(tolerance, 0.02 * inside);
  EXPECT_NEAR(averages.granular_temperature, 1, 1e-12);
  EXPECT_LT(run.ledger_error, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Along, GasBetweenWalls,
                         testing::Values(Walled{2, "x", 0}, Walled{2, "y", 1}, Walled{3, "x", 0},
                                         Walled{3, "y", 1}, Walled{3, "z", 2}),
                         [](const auto& walled) {
                           return walled.param.axis + "_in_" +
                                  std::to_string(walled.param.dimension) + "_dimensions";
                         });

}  // namespace
}  // namespace zenosphere
