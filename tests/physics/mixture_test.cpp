#include "support/mixture.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "flow/measurements.hpp"

namespace zenosphere {
namespace {

using support::Box;
using support::Gas;
using support::Kind;
using support::State;
using support::Vector;

constexpr double unbounded = std::numeric_limits<double>::infinity();

double solids_of(const std::vector<Kind>& kinds) {
  double volume = 0;
  for (const Kind& kind : kinds) {
    volume += kind.spheres * std::numbers::pi / 6 * std::pow(kind.diameter, 3);
  }
  return volume;
}

/// Boublik, J. Chem. Phys. 53 (1970) 471; Mansoori, Carnahan, Starling & Leland, J. Chem. Phys. 54
/// (1971) 1523.
double bmcsl(const std::vector<Kind>& kinds, double volume) {
  std::array<double, 4> xi{};
  for (const Kind& kind : kinds) {
    for (std::size_t k = 0; k < 4; ++k) {
      xi[k] += std::numbers::pi / 6 * kind.spheres / volume *
               std::pow(kind.diameter, static_cast<double>(k));
    }
  }
  const double room = 1 - xi[3];
  return 1 / room + 3 * xi[1] * xi[2] / (xi[0] * room * room) +
         std::pow(xi[2], 3) * (3 - xi[3]) / (xi[0] * std::pow(room, 3));
}

struct Watched {
  Gas gas;
  Measurements<3, double> measurements;

  Watched(const Gas& start, double after_time) : gas(start), measurements(gas, after_time) {}

  void go(std::int64_t collisions) {
    while (gas.collisions() < collisions) measurements.observe(support::next(gas), gas);
  }
};

Watched cube_of(const std::vector<Kind>& kinds, double phi, const ContactRules<double>& rules,
                double shear_rate = 0, double spin = 0, double after_time = 0) {
  const double side = std::cbrt(solids_of(kinds) / phi);
  double largest = 0;
  for (const Kind& kind : kinds) largest = std::max(largest, kind.diameter);
  State start = support::random_mixture(kinds, {side, side, side}, 1, 5);
  if (spin > 0) support::add_spins(start, spin, 6);
  return Watched(Gas(Box({side, side, side}, shear_rate, 1.1 * largest), start, rules), after_time);
}

TEST(Mixture, HasThePressureOfBoublikMansooriCarnahanStarlingAndLeland) {
  const std::array<std::vector<Kind>, 3> compositions{{{{250, 1.4, 2.744}, {250, 1, 1}},
                                                       {{100, 2, 8}, {400, 1, 1}},
                                                       {{400, 1.2, 0.2}, {100, 0.8, 5}}}};
  for (const auto& kinds : compositions) {
    const double phi = 0.3;
    Watched run = cube_of(kinds, phi, {1.0}, 0, 0, 1);
    run.go(100 * 500);
    const double expected = bmcsl(kinds, run.gas.box().volume());
    // 200 collisions per sphere of 500 spheres: the pressure scatters by 0.5 % between seeds.
    EXPECT_NEAR(run.measurements.averages(run.gas)->compressibility_factor / expected, 1, 0.025);
    EXPECT_LT(run.measurements.ledger_error(run.gas), 1e-12);
  }
}

TEST(Mixture, OfElasticSpheresComesToOneTemperature) {
  Watched run = cube_of({{200, 1.5, 8}, {200, 1, 1}}, 0.3, {1.0}, 0, 0, 5);
  run.go(80'000);
  const auto averages = run.measurements.averages(run.gas);
  ASSERT_EQ(averages->temperature_of_kind.size(), 2);
  // Each kind has 600 degrees of freedom: T scatters by sqrt(2/600) = 6 % at a moment; the time is
  // that of a hundred collisions a sphere, of which some ten forget it.
  EXPECT_NEAR(averages->temperature_of_kind[0] / averages->temperature_of_kind[1], 1, 0.1);
  EXPECT_NEAR((averages->temperature_of_kind[0] + averages->temperature_of_kind[1]) / 2,
              averages->granular_temperature, 1e-12);
}

TEST(Mixture, UnderShearClosesItsLedgerAndKeepsItsMomentum) {
  Watched run = cube_of({{60, 1.4, 5}, {60, 1, 0.5}}, 0.3, {0.8}, 1);
  run.go(20'000);
  EXPECT_LT(run.measurements.ledger_error(run.gas), 1e-11);
  Vector momentum;
  for (std::int32_t i = 0; i < run.gas.spheres(); ++i) {
    momentum += run.gas.peculiar_velocity(i) * run.gas.grains().mass(i);
  }
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(momentum[axis], 0, 1e-10);
}

TEST(Mixture, OfRoughSpheresUnderShearClosesItsLedger) {
  Watched run =
      cube_of({{60, 1.4, 5}, {60, 1, 0.5}}, 0.3, support::rough({0.8, 0.3, 0.2}, 2), 1, 1);
  run.go(20'000);
  EXPECT_LT(run.measurements.ledger_error(run.gas), 1e-11);
}

TEST(Mixture, OfUnitSpheresGivesTheDigitsOfUnitSpheres) {
  // The whole of the general path, with sizes and masses of 1 and a table: no bit may differ.
  const State unit = support::random_gas(100, {6, 6, 6}, 1, 9);
  State given = unit;
  given.grains.diameters.assign(100, 1);
  given.grains.masses.assign(100, 1);
  ContactRules<double> rules{0.7};
  rules.table.emplace(1, ContactConstants<double>{0.7});
  Gas one(Box({6, 6, 6}, 1), unit, {0.7});
  Gas other(Box({6, 6, 6}, 1), given, rules);
  support::expect_same_collisions(one, other, 5000);
}

TEST(RoughGas, WithoutFrictionOrWithBetaOfMinusOneGivesTheSmoothDigits) {
  const State start = support::random_gas(100, {6, 6, 6}, 1, 9);
  State spinning = start;
  support::add_spins(spinning, 1, 10);
  for (const auto& constants :
       {ContactConstants<double>{0.7, -1, 0.5}, ContactConstants<double>{0.7, 0.5, 0}}) {
    Gas smooth(Box({6, 6, 6}, 1), start, {0.7});
    Gas rough(Box({6, 6, 6}, 1), spinning, support::rough(constants));
    support::expect_same_collisions(smooth, rough, 3000);
    EXPECT_EQ(rough.spins(), spinning.spins);
  }
}

TEST(RoughGas, PerfectlyElasticKeepsItsEnergyAndSharesItEqually) {
  // e = 1, beta0 = 1, mu unbounded. Spins are at rest at first.
  Watched run = cube_of({{500, 1, 1}}, 0.3, support::rough({1, 1, unbounded}), 0, 0, 10);
  const double energy = support::energy(run.gas);
  run.go(250'000);
  EXPECT_NEAR(support::energy(run.gas) / energy, 1, 1e-12);
  EXPECT_LT(run.measurements.ledger_error(run.gas), 1e-12);
  // 1500 degrees of freedom each: T scatters by sqrt(2/1500) = 3.7 % at a moment, and is forgotten
  // after some 5 of 1000 collisions a sphere: 0.3 %.
  const auto averages = run.measurements.averages(run.gas);
  EXPECT_NEAR(*averages->rotational_temperature / averages->granular_temperature, 1, 0.015);
}

/// Mean of T_rot / T_tr of spheres that cool, e = 0.9, beta0 = 0.5 and mu unbounded, from 20
/// collisions a sphere on: the ratio is reached after some five.
double ratio_of_temperatures(std::optional<double> inertia) {
  ContactRules<double> rules = support::rough({0.9, 0.5, unbounded});
  rules.inertia = inertia;
  Watched run = cube_of({{2000, 1, 1}}, 0.05, rules);
  run.go(20'000);
  double ratio = 0;
  constexpr int samples = 20;
  for (int n = 0; n < samples; ++n) {
    run.go(run.gas.collisions() + 1000);
    double turning = 0;
    double flying = 0;
    for (std::int32_t i = 0; i < run.gas.spheres(); ++i) {
      const auto& spin = run.gas.spins()[static_cast<std::size_t>(i)];
      turning += run.gas.moment_of_inertia(i) * dot(spin, spin);
      const Vector velocity = run.gas.peculiar_velocity(i);
      flying += dot(velocity, velocity);
    }
    ratio += turning / flying / samples;
  }
  EXPECT_LT(run.measurements.ledger_error(run.gas), 1e-12);
  return ratio;
}

TEST(RoughGas, CoolsWithTheRatioOfTemperaturesOfTheory) {
  // Huthmann & Zippelius, Phys. Rev. E 56 (1997) R6275: e = 0.9, beta = 0.5 of solid spheres:
  // eta = 0.4 x 1.5 / 2.8 = 0.2142857, A = 0.0475 + eta (1 - eta) = 0.2158673, B = eta^2/0.4 =
  // 0.1147959, C = (eta/0.4)(1 - eta/0.4) = 0.2487245; K = (A - C)/(2 B) = -0.1431111,
  // R = K + sqrt(K^2 + 1) = 0.8670771.
  // 6000 degrees of freedom each: sqrt(2/6000 x 2) = 2.6 % at a moment; the theory holds for a
  // Gaussian homogeneous gas.
  EXPECT_NEAR(ratio_of_temperatures(std::nullopt), 0.8671, 0.06);
}

TEST(RoughGas, OfShellsCoolsWithTheRatioOfTheirMomentOfInertia) {
  // As above with q = 2/3: eta = (2/3) 1.5 / (10/3) = 0.3, A = 0.0475 + 0.21 = 0.2575,
  // B = 0.09 x 1.5 = 0.135, C = 0.45 x 0.55 = 0.2475; K = 0.01/0.27 = 0.0370370,
  // R = 0.0370370 + 1.0006856 = 1.0377227, three tolerances from that of solid spheres.
  EXPECT_NEAR(ratio_of_temperatures(2.0 / 3), 1.0377, 0.06);
}

TEST(Obstacles, KeepTheirVelocityAndDoTheWorkOfAMovingWall) {
  State start = support::random_mixture({{10, 2, 1}, {90, 1, 1}}, {8, 8, 8}, 1, 3);
  start.grains.immobile.assign(100, 0);
  for (std::size_t i = 0; i < 10; ++i) {
    start.grains.immobile[i] = 1;
    start.velocities[i] = {{0.5, 0, 0}};
  }
  const auto immobile = start.velocities;
  Watched run(Gas(Box({8, 8, 8}, 0, 2.2), start, support::rough({0.8, 0.2, 0.5}, 2)), 0);
  run.go(5000);
  for (std::int32_t i = 0; i < 10; ++i) {
    EXPECT_EQ(run.gas.peculiar_velocity(i), immobile[static_cast<std::size_t>(i)]);
    EXPECT_EQ(run.gas.spins()[static_cast<std::size_t>(i)], (Spin<3, double>{}));
  }
  EXPECT_LT(run.measurements.ledger_error(run.gas), 1e-11);
}

/// How many of 4000 collisions of elastic spheres among as many of a mass, or immobile ones, are
/// those of pairs that overlap; -1: `stop` has ended the run at one.
int overlaps_among(double mass, bool are_immobile, OverlapRule overlap) {
  State start = support::random_mixture({{50, 1, mass}, {50, 1, 1}}, {6.4, 6.4, 6.4}, 1, 4);
  if (are_immobile) {
    start.grains.immobile.assign(100, 0);
    for (std::size_t i = 0; i < 50; ++i) {
      start.grains.immobile[i] = 1;
      start.velocities[i] = {};
    }
  }
  Gas gas(Box({6.4, 6.4, 6.4}, 0, 1.1), start, {1, overlap});
  int overlaps = 0;
  while (gas.collisions() < 4000) {
    const auto collision = gas.next_collision(1e6);
    if (!collision) return -1;
    overlaps += collision->overlapping;
  }
  return overlaps;
}

// What another sphere does to the partner of a meeting does not move such a partner: the meeting,
// foretold again, must not be found to be over.
TEST(Obstacles, AreNotOverlappedByTheSpheresThatHitThem) {
  for (const OverlapRule rule : {OverlapRule::rewind, OverlapRule::immediate, OverlapRule::stop}) {
    EXPECT_EQ(overlaps_among(1, true, rule), 0);
    EXPECT_EQ(overlaps_among(1e30, false, rule), 0);
  }
}

TEST(Obstacles, AreNotKicked) {
  State start = support::random_gas(20, {6, 6, 6}, 1, 3);
  start.grains.immobile.assign(20, 0);
  start.grains.immobile[7] = 1;
  start.velocities[7] = {};
  Gas gas(Box({6, 6, 6}, 0), start, {0.8});
  gas.kick(std::vector<Vector>(20, Vector{{1, 1, 1}}));
  EXPECT_EQ(gas.peculiar_velocity(7), (Vector{}));
  EXPECT_NEAR(gas.peculiar_velocity(3)[0], start.velocities[3][0] + 1, 1e-15);
}

TEST(Mixture, BetweenWallsBouncesOffAtItsRadius) {
  // A sphere of diameter 3 and mass 5 flies down at 1 from 4 above the floor: its surface is 2.5
  // away. e = 0.5 of the wall: it comes back at 0.5 with a momentum changed by 7.5.
  using Plane = Simulation<2, double>;
  Configuration<2, double> start{{{5, 4}}, {{0, -1}}};
  start.grains.diameters = {3};
  start.grains.masses = {5};
  Plane plane(ShearBox<2, double>({10, 10}, 0, 3.3, 1), start, {1.0},
              {.walls = Walls<double>{.axis = 1, .restitution = 0.5}});
  const auto collision = plane.next_collision(10).value();
  EXPECT_DOUBLE_EQ(plane.time(), 2.5);
  EXPECT_DOUBLE_EQ(collision.change[1], 7.5);
  EXPECT_DOUBLE_EQ(plane.peculiar_velocity(0)[1], 0.5);
  EXPECT_DOUBLE_EQ(plane.configuration().positions[0][1], 1.5);
}

TEST(Mixture, OnALineTakesSizesAndMasses) {
  // Rods of 2 and 1, mass 3 and 1, 4 apart: the gap of 2.5 closes at 1; e = 0.5: the momentum
  // changes by 1.5 x 3/4.
  using OnALine = Simulation<1, double>;
  Configuration<1, double> start{{{2}, {6}}, {{1}, {0}}};
  start.grains.diameters = {2, 1};
  start.grains.masses = {3, 1};
  OnALine line(ShearBox<1, double>({20}, 0, 2.2), start, {0.5});
  const auto collision = line.next_collision(10).value();
  EXPECT_DOUBLE_EQ(line.time(), 2.5);
  EXPECT_DOUBLE_EQ(collision.gap_before, 2.5 / 1.5);
  EXPECT_DOUBLE_EQ(collision.change[0], -1.125);
  EXPECT_DOUBLE_EQ(line.peculiar_velocity(0)[0], 1 - 0.375);
  EXPECT_DOUBLE_EQ(line.peculiar_velocity(1)[0], 1.125);
}

TEST(Mixture, RefusesCellsThatAreTooNarrowForItsLargestSphere) {
  State start = support::random_mixture({{1, 2, 1}, {5, 1, 1}}, {8, 8, 8}, 1, 3);
  EXPECT_THROW(Gas(Box({8, 8, 8}, 0, 1.5), start, {1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace zenosphere
