#include <gtest/gtest.h>

#include <cmath>

#include "engine/simulation.hpp"
#include "engine/start.hpp"
#include "support/gas.hpp"

namespace zenosphere {
namespace {

double granular_temperature(const Simulation<3, double>& simulation) {
  double twice_energy = 0;
  for (std::int32_t i = 0; i < simulation.spheres(); ++i) {
    const auto velocity = simulation.peculiar_velocity(i);
    twice_energy += dot(velocity, velocity);
  }
  return twice_energy / (3 * simulation.spheres());
}

// Haff, J. Fluid Mech. 134 (1983) 401, with the Sonine correction of van Noije & Ernst, Granular
// Matter 1 (1998) 57. For e = 0.9, phi = 0.3, T0 = 1: tau = 3.146, omega0 = 10.1. In terms of the
// collisions per sphere n = omega0 tau ln(1 + t/tau) it reads T = exp(-2 n/(omega0 tau)).
TEST(CoolingGas, TemperatureFollowsHaffsLawForEightCollisionsPerSphere) {
  const std::int32_t spheres = 4000;
  const double side = box_side<3>(spheres, 0.3);
  const auto start = make_start<3>({.arrangement = Arrangement::random,
                                    .spheres = spheres,
                                    .granular_temperature = 1,
                                    .seed = 7},
                                   support::cube(side));
  Simulation<3, double> gas(ShearBox<3, double>({side, side, side}, 0), start, {0.9});
  for (const double per_sphere : {2.0, 4.0, 6.0, 8.0}) {
    while (2.0 * static_cast<double>(gas.collisions()) < per_sphere * spheres) {
      gas.next_collision(1e9);
    }
    const double expected = std::exp(-2 * per_sphere / (10.1 * 3.146));
    EXPECT_NEAR(granular_temperature(gas), expected, 0.02 * expected) << per_sphere;
  }
  // tau itself: T = T0/(1 + t/tau)^2 at the time reached.
  const double haff = std::pow(1 + gas.time() / 3.146, -2);
  EXPECT_NEAR(granular_temperature(gas), haff, 0.02 * haff);
}

}  // namespace
}  // namespace zenosphere
