#include "engine/start.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "support/gas.hpp"

namespace zenosphere {
namespace {

using support::State;
using support::Vector;

/// Distance of the closest pair in the plain periodic cube, diameters.
double closest_distance(const State& state, double side) {
  double closest = side;
  for (std::size_t i = 0; i < state.positions.size(); ++i) {
    for (std::size_t j = i + 1; j < state.positions.size(); ++j) {
      closest = std::min(closest, support::nearest_distance(state.positions[i], state.positions[j],
                                                            {side, side, side}));
    }
  }
  return closest;
}

void expect_inside(const State& state, double side) {
  for (const Vector& position : state.positions) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(position[axis], 0);
      EXPECT_LT(position[axis], side);
    }
  }
}

/// FNV-1a over the bits of all positions and velocities, http://www.isthe.com/chongo/tech/comp/fnv.
std::uint64_t hash_of(const State& state) {
  std::uint64_t hash = 14695981039346656037u;
  const auto add = [&hash](const std::vector<Vector>& vectors) {
    for (const Vector& vector : vectors) {
      for (int axis = 0; axis < 3; ++axis) {
        const auto bits = std::bit_cast<std::uint64_t>(vector[axis]);
        for (int shift = 0; shift < 64; shift += 8) {
          hash = (hash ^ (bits >> shift & 0xff)) * 1099511628211u;
        }
      }
    }
  };
  add(state.positions);
  add(state.velocities);
  return hash;
}

State fcc_start(std::uint64_t seed) {
  return make_start<3>({Arrangement::fcc, 108, 6e-3, seed}, support::cube(box_side<3>(108, 0.3)));
}

State random_start(std::uint64_t seed) {
  return make_start<3>({Arrangement::random, 60, 1, seed}, support::cube(box_side<3>(60, 0.3)));
}

State dense_start(std::uint64_t seed) {
  return make_start<3>({Arrangement::random, 60, 1, seed}, support::cube(box_side<3>(60, 0.6)));
}

TEST(BoxSide, IsTheCubeRootOfTheVolume) {
  // 4000 spheres at 0.3: L^3 = 4000 pi / 1.8 = 6981.3170, L = 19.112278.
  EXPECT_NEAR(box_side<3>(4000, 0.3), 19.112278, 5e-7);
  EXPECT_DOUBLE_EQ(box_side<3>(8, std::numbers::pi / 6), 2);
  for (const std::int64_t spheres : {30, 500, 108000}) {
    const double side = box_side<3>(spheres, 0.37);
    EXPECT_DOUBLE_EQ(static_cast<double>(spheres) * std::numbers::pi / 6 / (side * side * side),
                     0.37);
  }
}

TEST(FccStart, HasEveryNeighbourAtTheSpacingOfTheLattice) {
  // 108 = 4 x 3^3: neighbours at side / (3 sqrt 2) = 5.733683 / 4.242641 = 1.351442.
  const double side = box_side<3>(108, 0.3);
  const State start = fcc_start(1);
  ASSERT_EQ(start.positions.size(), 108u);
  expect_inside(start, side);
  EXPECT_NEAR(closest_distance(start, side), side / (3 * std::numbers::sqrt2), 1e-14);
  for (const Vector& place : start.positions) {
    int neighbours = 0;
    for (const Vector& other : start.positions) {
      const double distance = support::nearest_distance(place, other, {side, side, side});
      if (distance > 0 && distance < 1.36) ++neighbours;
    }
    EXPECT_EQ(neighbours, 12);
  }
}

TEST(FccStart, NeedsFourTimesACubeOfSpheres) {
  EXPECT_THROW(make_start<3>({Arrangement::fcc, 107, 1, 1}, support::cube(6)),
               std::invalid_argument);
  EXPECT_NO_THROW(make_start<3>({Arrangement::fcc, 32, 1, 1}, support::cube(6)));
}

TEST(RandomStart, IsFreeOfOverlapsUpToAHalf) {
  for (const double fraction : {0.01, 0.3, 0.45, 0.5}) {
    const double side = box_side<3>(100, fraction);
    const State start = make_start<3>({Arrangement::random, 100, 1, 2}, support::cube(side));
    ASSERT_EQ(start.positions.size(), 100u);
    expect_inside(start, side);
    // A pair that has just collided may overlap by the rounding of coordinates near 5.
    EXPECT_GE(closest_distance(start, side), 1 - 1e-14) << fraction;
  }
}

TEST(RandomStart, WorksInTheSmallestBox) {
  const State start = make_start<3>({Arrangement::random, 5, 1, 2}, support::cube(2.1));
  EXPECT_GE(closest_distance(start, 2.1), 1 - 1e-14);
}

TEST(RandomStart, GrowsWhereItIsDenser) {
  const double side = box_side<3>(100, 0.62);
  const State start = make_start<3>({Arrangement::random, 100, 1, 2}, support::cube(side));
  expect_inside(start, side);
  EXPECT_GE(closest_distance(start, side), 1);
}

TEST(FccStart, PutsSpheresOfDifferentDiametersInRandomOrderWhereTheyFit) {
  // Neighbours are 1.3514 apart: 1.3 and 1.4 fit beside each other, two of 1.4 do not.
  std::vector<double> diameters(108, 1.0);
  diameters[0] = 1.4;
  diameters[1] = 1.3;
  const auto cube = support::cube(box_side<3>(108, 0.3));
  const State start = make_start<3>({Arrangement::fcc, 108, 1, 1, {diameters}}, cube);
  EXPECT_NE(start.positions, fcc_start(1).positions);
  std::fill(diameters.begin(), diameters.end(), 1.4);
  EXPECT_THROW(make_start<3>({Arrangement::fcc, 108, 1, 1, {diameters}}, cube),
               std::invalid_argument);
}

TEST(RandomStart, FailsWhereOverlapsCannotBeRemoved) {
  // 0.76 is above the closest packing of spheres, pi / sqrt(18) = 0.7405.
  EXPECT_THROW(make_start<3>({Arrangement::random, 30, 1, 2}, support::cube(box_side<3>(30, 0.76))),
               std::invalid_argument);
}

TEST(Start, HasZeroMomentumAndTheWantedTemperature) {
  for (const State& start : {fcc_start(1), random_start(1)}) {
    Vector sum;
    double twice_energy = 0;
    for (const Vector& velocity : start.velocities) {
      sum += velocity;
      twice_energy += dot(velocity, velocity);
    }
    const auto spheres = static_cast<double>(start.velocities.size());
    // One rounding of 1e-16 per sphere and sum.
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(sum[axis], 0, spheres * 1e-15);
    const double wanted = spheres == 108 ? 6e-3 : 1;
    EXPECT_NEAR(twice_energy / (3 * spheres) / wanted, 1, 1e-14);
  }
}

TEST(Start, SharesTheTemperatureByMassAndLeavesImmobileSpheresAtRest) {
  Grains<double> grains;
  grains.masses.assign(300, 1);
  std::fill(grains.masses.begin(), grains.masses.begin() + 150, 100.0);
  grains.immobile.assign(300, 0);
  grains.immobile[3] = 1;
  Random random(1);
  const auto velocities = thermal_velocities<3>(300, 2, random, grains);
  Vector momentum;
  double heavy = 0;
  double light = 0;
  for (std::size_t i = 0; i < 300; ++i) {
    if (i == 3) continue;
    momentum += velocities[i] * grains.masses[i];
    (i < 150 ? heavy : light) += grains.masses[i] * dot(velocities[i], velocities[i]);
  }
  EXPECT_EQ(dot(velocities[3], velocities[3]), 0);
  EXPECT_NEAR((heavy + light) / 3 / 299, 2, 1e-13);
  // 450 components each: their variances differ by less than five times sqrt(2 * 2 / 450).
  EXPECT_NEAR(heavy / light, 149.0 / 150, 5 * 0.094);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(momentum[axis], 0, 1e-10);
}

TEST(Start, ColdSpheresAreAtRest) {
  const State start = make_start<3>({Arrangement::fcc, 32, 0, 1}, support::cube(6));
  for (const Vector& velocity : start.velocities) EXPECT_EQ(dot(velocity, velocity), 0);
}

TEST(Start, IsTheSameBitsForTheSameSeedOnEveryMachine) {
  // The hashes were taken from the first version of these starts. If one of them differs, runs of
  // older case files cannot be repeated any more: that needs a line in the change log.
  EXPECT_EQ(hash_of(fcc_start(1)), 2887323448742501787u);
  EXPECT_EQ(hash_of(random_start(1)), 6756523806625830589u);
  EXPECT_EQ(hash_of(dense_start(1)), 7923053839115598510u);
}

TEST(Start, OfAnotherSeedDiffers) {
  EXPECT_EQ(fcc_start(1).positions, fcc_start(2).positions);  // the lattice itself has no seed
  EXPECT_NE(fcc_start(1).velocities, fcc_start(2).velocities);
  EXPECT_NE(random_start(1).positions, random_start(2).positions);
  EXPECT_NE(random_start(1).velocities, random_start(2).velocities);
}

}  // namespace
}  // namespace zenosphere
