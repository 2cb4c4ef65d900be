#include <gtest/gtest.h>

#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "physics/oracle.hpp"
#include "support/mixture.hpp"

namespace zenosphere {
namespace {

using support::Box;
using support::Gas;
using support::Kind;
using support::State;
using support::Vector;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Mixture {
  std::string name;
  std::vector<Kind> kinds;  ///< the largest first
  Vector sides;
  double shear_rate;
  ContactRules<double> rules;
  double cell_width;
  int immobile = 0;  ///< so many of the last kind
  double spin = 0;   ///< of the start
  int rounds = 60;   ///< fewer of those that cool, whose flights become long

  friend void PrintTo(const Mixture& mixture, std::ostream* out) { *out << mixture.name; }
};

Gas gas_of(const Mixture& mixture) {
  State start = support::random_mixture(mixture.kinds, mixture.sides, 1.5, 11);
  if (mixture.spin > 0) support::add_spins(start, mixture.spin, 12);
  if (mixture.immobile > 0) start.grains.immobile.resize(start.positions.size());
  for (int n = 0; n < mixture.immobile; ++n) {
    const std::size_t i = start.positions.size() - 1 - static_cast<std::size_t>(n);
    start.grains.immobile[i] = 1;
    start.velocities[i] = {};
    if (!start.spins.empty()) start.spins[i] = {};
  }
  return Gas(Box(mixture.sides, mixture.shear_rate, mixture.cell_width), start, mixture.rules);
}

class MixtureEngine : public testing::TestWithParam<Mixture> {};

TEST_P(MixtureEngine, AgreesWithTheOracleCollisionByCollision) {
  // The tolerance is that of the smooth spheres of one size (oracle_test.cpp): small spheres and
  // light ones are deflected more, so that the oracle begins anew twice as often.
  Gas gas = gas_of(GetParam());
  for (int round = 0; round < GetParam().rounds; ++round) {
    ASSERT_NO_FATAL_FAILURE(expect_collisions_of_oracle(gas, gas.spheres(), 1e-10))
        << "round " << round;
  }
}

ContactRules<double> unlike_pairs() {
  ContactRules<double> rules;
  rules.table.emplace(2, ContactConstants<double>{0.9, 0.5, 0.2});
  rules.table->set(0, 1, {0.7, 0, infinity});
  rules.table->set(1, 1, {0.8, -1, 0});
  return rules;
}

ContactRules<double> rough_shells() {
  ContactRules<double> rules = support::rough({0.9, 0.4, 0.3}, 2);
  rules.inertia = 2.0 / 3;
  return rules;
}

INSTANTIATE_TEST_SUITE_P(
    All, MixtureEngine,
    testing::Values(
        Mixture{"of_two_sizes", {{15, 1.4, 2.7}, {15, 1, 1}}, {5, 5, 5}, 1, {0.9}, 1.6},
        Mixture{
            "of_two_sizes_unsheared", {{15, 1.4, 2.7}, {15, 1, 1}}, {5, 4.5, 5.5}, 0, {0.9}, 1.5},
        Mixture{"of_two_masses", {{15, 1, 10}, {15, 1, 1}}, {4, 4, 4}, 1, {0.9}, 1.1},
        Mixture{
            "of_heavy_small_spheres", {{4, 2, 1}, {26, 0.6, 20}}, {4.5, 4.5, 4.5}, 1, {0.8}, 2.1},
        Mixture{
            "of_one_to_five", {{2, 2.5, 15}, {28, 0.5, 0.125}}, {5.2, 5.2, 5.2}, 1, {0.95}, 2.6},
        Mixture{"of_one_to_ten",
                {{2, 3, 1000}, {98, 0.3, 1}},
                {6.2, 6.2, 6.2},
                1,
                {0.9},
                3.05,
                0,
                0,
                5},
        Mixture{"of_one_to_ten_that_weigh_the_same",
                {{3, 3, 1}, {47, 0.3, 1}},
                {6.2, 6.2, 6.2},
                0.5,
                {0.95},
                3.05,
                0,
                0,
                5},
        Mixture{"of_many_sizes",
                {{2, 2, 8}, {4, 1.3, 2}, {8, 0.9, 1}, {16, 0.5, 0.2}, {32, 0.25, 0.02}},
                {4.4, 4.4, 4.4},
                1,
                {0.9},
                2.15,
                0,
                0,
                10},
        Mixture{
            "of_large_obstacles", {{30, 0.4, 1}, {3, 2, 1}}, {5, 5, 5}, 0, {0.9}, 2.3, 3, 0, 10},
        Mixture{"of_small_spheres", {{30, 0.7, 0.3}}, {3, 3, 3}, 2, {0.9}, 1.05},
        Mixture{"with_obstacles", {{20, 1.2, 1}, {10, 0.8, 1}}, {5, 5, 5}, 0, {0.9}, 1.3, 5},
        Mixture{"that_is_rough",
                {{15, 1.4, 2.7}, {15, 1, 1}},
                {5, 5, 5},
                1,
                support::rough({0.9, 0.4, 0.3}, 2),
                1.6,
                0,
                2},
        Mixture{"that_is_perfectly_rough",
                {{30, 1, 1}},
                {4, 4, 4},
                1,
                support::rough({0.9, 1, infinity}, 1),
                1.1,
                0,
                2},
        Mixture{"of_rough_shells",
                {{15, 1.4, 2.7}, {15, 1, 1}},
                {5, 5, 5},
                1,
                rough_shells(),
                1.6,
                0,
                2},
        Mixture{"of_kinds_with_constants_of_their_own",
                {{15, 1.4, 2.7}, {15, 1, 1}},
                {5, 5, 5},
                1,
                unlike_pairs(),
                1.6,
                0,
                2},
        Mixture{"with_rough_obstacles",
                {{20, 1.2, 1}, {10, 0.8, 1}},
                {5, 5, 5},
                0,
                support::rough({0.9, 0.4, 0.3}, 2),
                1.3,
                5,
                2,
                20}),
    [](const auto& mixture) { return mixture.param.name; });

}  // namespace
}  // namespace zenosphere
