#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/run_text.hpp"

namespace zenosphere {
namespace {

const char* const elastic_gas = R"(
[system]
dimension = 3
spheres = 4000
restitution = 1
solids_volume_fraction = 0.3
[start]
arrangement = "random"
granular_temperature = 1
[drive]
kind = "none"
[run]
collisions = 400000
)";

// 200 collisions per sphere: seeds scatter by 0.2 % around the mean, so 1 % is 5 standard errors.
constexpr double one_percent = 0.01;

TEST(ElasticGas, PressureAndCollisionRateAreThoseOfTheHardSphereFluid) {
  const Summary run = test::run_text(elastic_gas);
  ASSERT_TRUE(run.averages);
  // Equation of state at phi = 0.3: Kolafa, Labik & Malijevsky, PCCP 6 (2004) 2335.
  const double z = 3.984;
  EXPECT_NEAR(run.averages->compressibility_factor, z, one_percent * z);
  // Enskog: 4 n g sqrt(pi T), g = (Z - 1)/(4 phi), n = 6 phi/pi; 10.1 at this state.
  const double g = (z - 1) / (4 * 0.3);
  const double rate = 4 * (6 * 0.3 / std::numbers::pi) * g * std::sqrt(std::numbers::pi);
  EXPECT_NEAR(run.averages->collision_rate, rate, one_percent * rate);
  // Closing speeds are distributed as v exp(-v^2/4): the mean is sqrt(pi).
  const double normal_speed = std::sqrt(std::numbers::pi);
  EXPECT_NEAR(run.averages->normal_speed, normal_speed, one_percent * normal_speed);
}

TEST(ElasticGas, DensestRandomStartIsAFluidInEquilibrium) {
  const Summary run =
      test::run_text(elastic_gas, {"system.solids_volume_fraction=0.5", "system.spheres=2000"});
  // Carnahan & Starling, J. Chem. Phys. 51 (1969) 635: (1 + phi + phi^2 - phi^3)/(1 - phi)^3 = 13.
  // Seeds scatter by 0.4 %; a start that is mixed too shortly is 3 % too high.
  EXPECT_NEAR(run.averages->compressibility_factor, 13, 0.02 * 13);
}

TEST(ElasticGas, EnergyIsConservedAndTheLedgerIsClosed) {
  const Summary run = test::run_text(elastic_gas, {"run.collisions=100000"});
  EXPECT_NEAR(run.averages->granular_temperature, 1, 1e-12);  // rounding of 1e5 collisions
  EXPECT_LT(run.ledger_error, 1e-12);
  EXPECT_EQ(run.verdict, Verdict::none);
}

TEST(ElasticGas, ImposedShearKeepsTheLedgerToo) {
  const Summary run = test::run_text(
      elastic_gas, {"drive.kind=shear", "drive.shear_rate=1", "system.restitution=0.9"});
  EXPECT_LT(run.ledger_error, 1e-10);
}

}  // namespace
}  // namespace zenosphere
