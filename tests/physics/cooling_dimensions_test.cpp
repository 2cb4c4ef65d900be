#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "support/run_text.hpp"

namespace zenosphere {
namespace {

const char* const cooling_everywhere = R"(
[system]
dimension = 2
spheres = 4000
restitution = 0.95
solids_volume_fraction = 0.3
[start]
arrangement = "random"
granular_temperature = 1
seed = 5
[drive]
kind = "none"
[run]
time = 1
)";

/// Energy lost per sphere, from the dissipation of a run: (D/2) (T0 - T).
double cooled_by(const Summary& run, int dimension, double density) {
  return 2 * run.averages->dissipation * run.time / (density * dimension);
}

// A collision takes (1 - e^2)/4 <v_n^2> = (1 - e^2) T from two disks, and each has omega of them:
// dT/dt = -(1 - e^2) omega T/D, so that T = T0/(1 + t/tau)^2 with 1/tau = (1 - e^2) omega0/(2 D).
// Haff, J. Fluid Mech. 134 (1983) 401; omega0 = 2 n g sqrt(pi) = 2.400, Sonine correction
// 1 + 3 a2/16, a2 = 16 (1-e)(1-2e^2)/(57 - 25 e + 30 e^2 (1-e)) = -0.0186 by van Noije & Ernst,
// Granular Matter 1 (1998) 57: tau = 17.15.
TEST(CoolingDisks, TemperatureFollowsHaffsLawForTenCollisionsPerDisk) {
  const double e = 0.95;
  const double density = 4 * 0.3 / std::numbers::pi;
  const double z = 1.01125 / 0.49;  // Henderson
  const double omega = 2 * density * (z - 1) / (2 * 0.3) * std::sqrt(std::numbers::pi);
  const double a2 = 16 * (1 - e) * (1 - 2 * e * e) / (57 - 25 * e + 30 * e * e * (1 - e));
  const double tau = 4 / ((1 - e * e) * omega * (1 + 3 * a2 / 16));
  for (const double time : {1.0, 2.5, 5.0}) {
    const Summary run = test::run_text(cooling_everywhere, {"run.time=" + std::to_string(time)});
    const double temperature = 1 - cooled_by(run, 2, density);
    const double expected = std::pow(1 + time / tau, -2);
    EXPECT_NEAR(temperature, expected, 0.01 * expected) << time;
    EXPECT_LT(run.ledger_error, 1e-10);
  }
}

// Rods that are nearly elastic nearly exchange their velocities, so that each one goes on through
// the others and slows down a little: at the start, from Gaussian velocities, with omega0 =
// 2 n g sqrt(T/pi) and g = 1/(1 - phi) (Tonks), by the same reasoning 1/tau = (1 - e^2) omega0/2.
// Later a2 goes to -16/63 instead of 0 and the rods cluster (McNamara & Young, Phys. Fluids A 4
// (1992) 496), so only the first tenth of tau is looked at: a2 grows to some hundredths, and 3
// a2/16 is 0.5 %. The sum of |v_i - v_j|^3 scatters by 1/sqrt(N) = 0.7 %; 4 % holds both.
TEST(CoolingRods, LoseEnergyAtFirstAsHaffSays) {
  const double e = 0.99;
  const double phi = 0.3;
  const double omega = 2 * phi / (1 - phi) / std::sqrt(std::numbers::pi);
  const double tau = 2 / ((1 - e * e) * omega);
  const double time = 0.1 * tau;
  const Summary run = test::run_text(
      cooling_everywhere, {"system.dimension=1", "system.spheres=20000", "system.restitution=0.99",
                           "run.time=" + std::to_string(time)});
  const double lost = cooled_by(run, 1, phi);
  const double expected = 1 - std::pow(1.1, -2);
  EXPECT_NEAR(lost, expected, 0.04 * expected);
  EXPECT_EQ(run.verdict, Verdict::none);
}

}  // namespace
}  // namespace zenosphere
