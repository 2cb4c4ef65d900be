#include <gtest/gtest.h>

#include <vector>

#include "engine/start.hpp"
#include "flow/measurements.hpp"
#include "support/gas.hpp"

namespace zenosphere {
namespace {

using support::Box;
using support::Gas;
using support::Record;
using support::State;
using support::Vector;

/// Box and start of 4 n^3 spheres at a solids volume fraction of 0.3 and unit temperature.
struct Setting {
  Vector sides;
  State start;
};

Setting lattice_gas(std::int32_t spheres) {
  const double side = box_side<3>(spheres, 0.3);
  return {{side, side, side},
          make_start<3>({Arrangement::fcc, spheres, 1, 5}, support::cube(side))};
}

TEST(Identities, PeculiarMomentumIsConservedUnderShear) {
  const Setting setting = lattice_gas(108);
  Gas gas(Box(setting.sides, 1), setting.start, {0.7});
  for (int n = 0; n < 2000; ++n) support::next(gas);
  ASSERT_GE(gas.now().units, 3);
  // 4000 roundings of speeds about 1, each below 1e-16, and as many cell crossings.
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(support::momentum(gas)[axis], 0, 1e-12);
}

TEST(Identities, EachCollisionTakesTheEnergyOfTheRestitution) {
  const double restitution = 0.6;
  const Setting setting = lattice_gas(108);
  Gas gas(Box(setting.sides, 0), setting.start, {restitution});
  for (int n = 0; n < 500; ++n) {
    std::vector<Vector> before;
    for (int i = 0; i < gas.spheres(); ++i) before.push_back(gas.peculiar_velocity(i));
    const double energy_before = support::twice_energy(gas) / 2;
    const Record collision = support::next(gas);
    const Vector relative = before[static_cast<std::size_t>(collision.j)] -
                            before[static_cast<std::size_t>(collision.i)];
    const double v_n = -dot(collision.impact.normal, relative);
    EXPECT_NEAR(collision.impact.normal_speed, v_n, 1e-14);
    // Energies are about 150, so that their difference is good to some 1e-14.
    EXPECT_NEAR(support::twice_energy(gas) / 2 - energy_before,
                -(1 - restitution * restitution) / 4 * v_n * v_n, 1e-12);
    EXPECT_NEAR(collision.impact.distance, 1, 1e-14);
    EXPECT_NEAR(dot(collision.impact.normal, collision.impact.normal), 1, 1e-15);
  }
}

TEST(Identities, EnergyLedgerOfAShearedRunIsBalanced) {
  const Setting setting = lattice_gas(500);
  Gas gas(Box(setting.sides, 1), setting.start, {0.9});
  Measurements<3, double> measurements(gas, 0);
  while (gas.now().units < 4) {
    measurements.observe(support::next(gas), gas);
    ASSERT_LT(gas.collisions(), 100000);  // about 10 per sphere and strain unit: 20000
  }
  ASSERT_GT(gas.collisions(), 5000);
  EXPECT_LT(measurements.ledger_error(gas), 1e-10);
  const Averages averages = measurements.averages(gas).value();
  // The terms of the ledger are of its own size, so that the balance is not one of zeros.
  EXPECT_GT(averages.shear_work, 0.1);
  EXPECT_GT(averages.dissipation, 0.1);
}

TEST(Identities, EnergyOfElasticSpheresIsConservedWithoutShear) {
  const Setting setting = lattice_gas(108);
  Gas gas(Box(setting.sides, 0), setting.start, {1.0});
  const double before = support::twice_energy(gas);
  for (int n = 0; n < 3000; ++n) support::next(gas);
  EXPECT_NEAR(support::twice_energy(gas) / before, 1, 1e-13);  // 3000 roundings of 1e-16 / 108
}

/// Compares collisions one by one: three per sphere, over which a deviation of 1e-15 grows by less
/// than 4^3 on average.
void expect_same_motion(Gas& one, Gas& other) {
  support::expect_like_collisions(one, other, 3 * one.spheres() / 2, 1e-12);
}

TEST(Identities, ShearRateZeroIsTheLimitOfVanishingShear) {
  // Cells that slide by 1e-20 a time unit: other stencils, other clock unit, the same motion.
  const Setting setting = lattice_gas(108);
  Gas resting(Box(setting.sides, 0), setting.start, {0.9});
  Gas creeping(Box(setting.sides, 1e-20), setting.start, {0.9});
  ASSERT_FALSE(resting.box().is_sheared());
  ASSERT_TRUE(creeping.box().is_sheared());
  expect_same_motion(resting, creeping);
}

TEST(Identities, AShiftOfTheOriginChangesOnlyRounding) {
  const Setting setting = lattice_gas(108);
  const double side = setting.sides[0];
  for (const int axis : {0, 1, 2}) {
    State shifted = setting.start;
    for (Vector& position : shifted.positions) {
      position[axis] += 0.371;  // no multiple of the cell width 1.147
      if (position[axis] >= side) position[axis] -= side;
    }
    Gas gas(Box(setting.sides, 1), setting.start, {0.9});
    Gas moved(Box(setting.sides, 1), shifted, {0.9});
    expect_same_motion(gas, moved);
  }
}

}  // namespace
}  // namespace zenosphere
