#include "flow/measurements.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/start.hpp"
#include "support/gas.hpp"

namespace zenosphere {
namespace {

using support::Box;
using support::Gas;
using support::State;

constexpr double gas_volume = 20 * 20 * 20;

/// Two spheres that meet head-on at time 1 at (6.5, 10, 10), and leave each other for good.
Gas head_on(double restitution) {
  return Gas(Box({20, 20, 20}, 0), {{{5, 10, 10}, {8, 10, 10}}, {{1, 0, 0}, {-1, 0, 0}}},
             {restitution});
}

/// Two spheres in shear that do not meet before time 2; peculiar velocities +-(0, 1, 0) at first.
Gas free_flight(double shear_rate) {
  return Gas(Box({20, 20, 20}, shear_rate), {{{5, 5, 5}, {15, 15, 15}}, {{0, 1, 0}, {0, -1, 0}}},
             {1.0});
}

/// Runs to `until` and stops there.
void run(Gas& gas, Measurements<3, double>& measurements, double until) {
  while (!gas.has_reached(until)) {
    if (const auto collision = gas.next_collision(until)) measurements.observe(*collision, gas);
    ASSERT_LT(gas.collisions(), 100000);
  }
}

// Speeds 1 until time 1, closing speed 2; impulse (1 + 1/2) 2 / 2 = 1.5; speeds 0.5 after it.
// Integral of sum v_x^2 to time 3: 2 x 1 + 2 x 0.25 x 2 = 3. Energy lost: (1 - 1/4) / 4 x 4 = 0.75.
TEST(Measurements, AverageTwoSpheresHeadOn) {
  Gas gas = head_on(0.5);
  Measurements<3, double> measurements(gas, 0);
  run(gas, measurements, 3);
  const Averages averages = measurements.averages(gas).value();
  EXPECT_DOUBLE_EQ(averages.to_time, 3);
  EXPECT_DOUBLE_EQ(averages.temperature_diagonal[0], 3.0 / (2 * 3));
  EXPECT_DOUBLE_EQ(averages.temperature_diagonal[1], 0);
  EXPECT_DOUBLE_EQ(averages.granular_temperature, 3.0 / (3 * 2 * 3));
  EXPECT_DOUBLE_EQ(averages.pressure_tensor[0], (3 + 1.5) / (gas_volume * 3));
  for (std::size_t ab = 1; ab < 9; ++ab) EXPECT_DOUBLE_EQ(averages.pressure_tensor[ab], 0);
  EXPECT_DOUBLE_EQ(averages.pressure, (3 + 1.5) / (3 * gas_volume * 3));
  EXPECT_DOUBLE_EQ(averages.compressibility_factor, (3 + 1.5) / 3);
  EXPECT_DOUBLE_EQ(averages.collision_rate, 2.0 / (2 * 3));  // one collision is one for each
  EXPECT_DOUBLE_EQ(averages.dissipation, 0.75 / (gas_volume * 3));
  EXPECT_DOUBLE_EQ(averages.normal_speed, 2);
  EXPECT_EQ(averages.shear_work, 0);
  EXPECT_LT(measurements.ledger_error(gas), 1e-15);
}

TEST(Measurements, AverageFromAfterTimeOnly) {
  // From 0.5 to 3: 2 x 1 x 0.5 + 2 x 0.25 x 2 = 2 of kinetic integral, and the collision.
  Gas before = head_on(0.5);
  Measurements<3, double> from_before(before, 0.5);
  run(before, from_before, 3);
  EXPECT_DOUBLE_EQ(from_before.averages(before)->granular_temperature, 2.0 / (3 * 2 * 2.5));
  EXPECT_DOUBLE_EQ(from_before.averages(before)->pressure, (2 + 1.5) / (3 * gas_volume * 2.5));
  EXPECT_DOUBLE_EQ(from_before.averages(before)->from_time, 0.5);
  // From 2 to 3: 2 x 0.25 x 1, and no collision any more.
  Gas after = head_on(0.5);
  Measurements<3, double> from_after(after, 2);
  run(after, from_after, 3);
  EXPECT_DOUBLE_EQ(from_after.averages(after)->granular_temperature, 0.5 / (3 * 2 * 1));
  EXPECT_DOUBLE_EQ(from_after.averages(after)->pressure, 0.5 / (3 * gas_volume * 1));
  EXPECT_EQ(from_after.averages(after)->collision_rate, 0);
  EXPECT_EQ(from_after.averages(after)->dissipation, 0);
}

// Four spheres fly apart along three axes, of mean 0; nothing else ever happens to them but one
// head-on collision that swaps two velocities: a2 is the same at every time. <v^2> = 1.5, <v^4>
// = 2.5; 9 independent components.
TEST(Measurements, TakeTheSonineCoefficientAtTheEndsOfIntervals) {
  Gas gas(Box({20, 20, 20}, 0),
          {{{5, 10, 10}, {8, 10, 10}, {10, 2, 2}, {10, 6, 6}},
           {{1, 0, 0}, {-1, 0, 0}, {0, std::sqrt(2.0), 0}, {0, -std::sqrt(2.0), 0}}},
          {1.0});
  Measurements<3, double> measurements(gas, 0, 0.25);
  run(gas, measurements, 1.2);
  ASSERT_EQ(gas.collisions(), 1);
  const auto a2 = measurements.averages(gas)->sonine_a2;
  ASSERT_TRUE(a2);
  EXPECT_NEAR(*a2, 3.0 / 5 * 2.5 / (1.5 * 1.5) * 11 / 9 - 1, 1e-14);
  EXPECT_EQ(measurements.series(gas).rows(), 4u);
}

// Peculiar velocities (-t, 1, 0) and opposite in shear of rate 1: at the end of the interval, 0.5,
// both have the square 1.25, so <v^4> = <v^2>^2, with 3 independent components.
TEST(Measurements, TakeTheSonineCoefficientOfThatMoment) {
  Gas gas = free_flight(1);
  Measurements<3, double> measurements(gas, 0, 0.5);
  run(gas, measurements, 0.75);
  EXPECT_NEAR(*measurements.averages(gas)->sonine_a2, 3.0 / 5 * 5 / 3 - 1, 1e-14);
}

TEST(Measurements, HaveNoSonineCoefficientBeforeTheFirstIntervalEnds) {
  Gas gas = head_on(0.5);
  Measurements<3, double> measurements(gas, 0);
  run(gas, measurements, 1.5);
  EXPECT_TRUE(std::isnan(measurements.averages(gas)->sonine_a2.value()));
  EXPECT_TRUE(measurements.averages(gas)->normal_stress_differences.empty());
}

TEST(Measurements, HaveNoAverageOverAnEmptySpan) {
  Gas gas = head_on(0.5);
  Measurements<3, double> measurements(gas, 2);
  EXPECT_FALSE(measurements.averages(gas));
  run(gas, measurements, 2);
  EXPECT_FALSE(measurements.averages(gas));
  run(gas, measurements, 2.25);
  EXPECT_TRUE(measurements.averages(gas));
}

// v_x = -+ rate t: with rate 1/2 the integrals over (t1, t2) of v_x^2, v_x v_y, v_y^2 for both
// spheres are (t2^3 - t1^3) / 6, -(t2^2 - t1^2) / 2 and 2 (t2 - t1).
TEST(Measurements, KnowFreeFlightInShearByHand) {
  for (const double from : {0.0, 1.0}) {
    const double to = 2;
    Gas gas = free_flight(0.5);
    Measurements<3, double> measurements(gas, from);
    run(gas, measurements, to);
    ASSERT_EQ(gas.collisions(), 0);
    const Averages averages = measurements.averages(gas).value();
    const double span = to - from;
    const double xx = (std::pow(to, 3) - std::pow(from, 3)) / 6;
    const double xy = -(to * to - from * from) / 2;
    EXPECT_NEAR(averages.pressure_tensor[0] * gas_volume * span, xx, 1e-13);
    EXPECT_NEAR(averages.pressure_tensor[1] * gas_volume * span, xy, 1e-13);
    EXPECT_NEAR(averages.pressure_tensor[3] * gas_volume * span, xy, 1e-13);
    EXPECT_NEAR(averages.pressure_tensor[4] * gas_volume * span, 2 * span, 1e-13);
    EXPECT_EQ(averages.pressure_tensor[8], 0);
    EXPECT_NEAR(averages.granular_temperature, (xx + 2 * span) / (3 * 2 * span), 1e-14);
    EXPECT_NEAR(averages.shear_work * gas_volume * span, -0.5 * xy, 1e-13);
    // The spheres' energy grows from 1 to 1 + (rate t)^2 = 2 at time 2: work 1 = rate x 2.
    EXPECT_NEAR(support::twice_energy(gas) / 2, 2, 1e-14);
    EXPECT_LT(measurements.ledger_error(gas), 1e-14);
  }
}

TEST(Measurements, DoNotDependOnHowOftenTheyAreAsked) {
  const double side = box_side<3>(32, 0.2);
  const State start = make_start<3>({Arrangement::fcc, 32, 1, 3}, support::cube(side));
  Gas one(Box({side, side, side}, 1), start, {0.8});
  Gas other(Box({side, side, side}, 1), start, {0.8});
  Measurements<3, double> once(one, 0.9);
  Measurements<3, double> often(other, 0.9);
  run(one, once, 3);
  for (int step = 1; step <= 300; ++step) {
    run(other, often, 0.01 * step);
    EXPECT_EQ(often.averages(other).has_value(), step > 90);
  }
  run(other, often, 3);
  ASSERT_GT(one.collisions(), 100);
  ASSERT_EQ(one.collisions(), other.collisions());
  EXPECT_EQ(once.averages(one)->pressure_tensor, often.averages(other)->pressure_tensor);
  EXPECT_EQ(once.averages(one)->granular_temperature, often.averages(other)->granular_temperature);
  EXPECT_EQ(once.ledger_error(one), often.ledger_error(other));
}

TEST(Measurements, AverageOfTwoSpansIsThatOfTheWhole) {
  // Energy integrals add up: 3 T(0..3) = 1 T(0..1) + 2 T(1..3).
  const double side = box_side<3>(32, 0.2);
  const State start = make_start<3>({Arrangement::fcc, 32, 1, 3}, support::cube(side));
  Gas gas(Box({side, side, side}, 1), start, {0.8});
  Measurements<3, double> whole(gas, 0);
  Measurements<3, double> late(gas, 1);
  const auto observe_until = [&](double until) {
    while (!gas.has_reached(until)) {
      if (const auto collision = gas.next_collision(until)) {
        whole.observe(*collision, gas);
        late.observe(*collision, gas);
      }
    }
  };
  observe_until(1);
  const Averages first = whole.averages(gas).value();
  observe_until(3);
  const Averages all = whole.averages(gas).value();
  const Averages second = late.averages(gas).value();
  EXPECT_NEAR(3 * all.granular_temperature,
              first.granular_temperature + 2 * second.granular_temperature, 1e-12);
  EXPECT_NEAR(3 * all.pressure, first.pressure + 2 * second.pressure, 1e-12);
  EXPECT_NEAR(3 * all.dissipation, first.dissipation + 2 * second.dissipation, 1e-12);
  EXPECT_NEAR(3 * all.collision_rate, first.collision_rate + 2 * second.collision_rate, 1e-12);
}

TEST(Measurements, TemperatureOfAnElasticGasStaysWhereItWas) {
  const double side = box_side<3>(108, 0.3);
  const State start = make_start<3>({Arrangement::fcc, 108, 2.5, 3}, support::cube(side));
  Gas gas(Box({side, side, side}, 0), start, {1.0});
  Measurements<3, double> measurements(gas, 0.3);
  run(gas, measurements, 1.5);
  ASSERT_GT(gas.collisions(), 500);
  // The energy is good to rounding, 1e-16 per collision.
  EXPECT_NEAR(measurements.averages(gas)->granular_temperature, 2.5, 1e-12);
  EXPECT_NEAR(measurements.averages(gas)->dissipation, 0, 1e-12);
}

}  // namespace
}  // namespace zenosphere
