// Micro benchmarks of what a collision is made of.

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/calendar.hpp"
#include "gas.hpp"
#include "model/contact.hpp"
#include "model/random.hpp"

namespace zenosphere::bench {

namespace {

constexpr std::int32_t gas_spheres = 4000;
constexpr double gas_fraction = 0.3;

GasRequest dense_gas(double restitution, double shear_rate) {
  return {.start = {.spheres = gas_spheres, .granular_temperature = 1},
          .solids_volume_fraction = gas_fraction,
          .restitution = restitution,
          .shear_rate = shear_rate};
}

/// Pairs as a prediction meets them: any direction, up to two diameters apart, thermal velocities.
std::vector<RelativeMotion<3, double>> neighbours(std::size_t count) {
  Random random(1);
  std::vector<RelativeMotion<3, double>> pairs;
  while (pairs.size() < count) {
    RelativeMotion<3, double> motion;
    for (int axis = 0; axis < 3; ++axis) {
      motion.dr[axis] = 4 * random.uniform() - 2;
      motion.dv[axis] = std::sqrt(2.0) * random.normal();
    }
    const double r2 = dot(motion.dr, motion.dr);
    if (r2 > 1 && r2 < 4) pairs.push_back(motion);
  }
  return pairs;
}

void contact_of_a_pair(benchmark::State& state) {
  const auto pairs = neighbours(4096);
  std::size_t k = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(contact(pairs[k]));
    k = (k + 1) % pairs.size();
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(contact_of_a_pair);

/// One collision's worth of calendar: the earliest event goes, and two spheres get a new one, one
/// of them in place of an event that it had. Spheres wait about 0.1 time units, as at phi = 0.3.
void calendar_events_of_a_collision(benchmark::State& state) {
  const auto spheres = static_cast<std::int32_t>(state.range(0));
  Random random(1);
  std::vector<double> waits(8192);
  for (double& wait : waits) wait = -0.1 * std::log(1 - random.uniform());
  Calendar<double> calendar(spheres);
  for (std::int32_t i = 0; i < spheres; ++i) calendar.schedule(i, waits[i % waits.size()]);
  std::size_t k = 0;
  for (auto _ : state) {
    const std::int32_t i = calendar.earliest();
    const double now = calendar.time(i);
    const auto partner = static_cast<std::int32_t>((i + 7919LL) % spheres);
    calendar.schedule(i, now + waits[k]);
    calendar.schedule(partner, now + waits[k + 1]);
    k = (k + 2) % waits.size();
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(calendar_events_of_a_collision)->Arg(gas_spheres)->Arg(1000000);

/// A kick that changes nothing makes a prediction for every sphere.
void prediction_of_a_sphere(benchmark::State& state) {
  auto gas = bench::gas<3>(dense_gas(1, 0));
  collide(gas, 10 * gas_spheres);
  const std::vector<Vec<3, double>> nothing(gas_spheres);
  for (auto _ : state) gas.kick(nothing);
  state.SetItemsProcessed(state.iterations() * gas_spheres);
}
BENCHMARK(prediction_of_a_sphere);

/// Everything that one collision costs, rebuilt lists and stale events included.
void collision_of_a_gas(benchmark::State& state) {
  const auto shear_rate = static_cast<double>(state.range(0));
  auto gas = bench::gas<3>(dense_gas(shear_rate > 0 ? 0.9 : 1.0, shear_rate));
  collide(gas, 10 * gas_spheres);
  for (auto _ : state) collide(gas, 1);
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(collision_of_a_gas)->ArgName("shear_rate")->Arg(0)->Arg(1);

}  // namespace

}  // namespace zenosphere::bench

BENCHMARK_MAIN();
