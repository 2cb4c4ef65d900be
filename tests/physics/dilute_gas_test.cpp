// Dilute gases, whose spheres are looked for cell by cell, without lists.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "engine/list_range.hpp"
#include "engine/start.hpp"
#include "model/archive.hpp"
#include "support/gas.hpp"

namespace zenosphere {
namespace {

using support::Box;
using support::Gas;
using support::State;
using support::Vector;

/// The box that a program makes for so many spheres, and wider cells, which are for lists.
Box box_of(std::int32_t spheres, double fraction, double shear_rate, double widen = 1) {
  const double side = box_side<3>(spheres, fraction);
  const std::array sides{side, side, side};
  return Box({sides}, shear_rate, widen * fitting_cell_width({sides, spheres}));
}

Gas gas_of(std::int32_t spheres, const Box& box, double restitution) {
  return Gas(box, support::random_gas(spheres, box.sides(), 1.5, 3), {restitution});
}

TEST(DiluteGas, HasNoListsBelowAFractionOf28PerCentInAllButSmallBoxes) {
  const auto looks_by_cells = [](std::int32_t spheres, double fraction) {
    return gas_of(spheres, box_of(spheres, fraction, 0), 1).looks_by_cells();
  };
  for (const double fraction : {0.006, 0.05, 0.1, 0.2, 0.275})
    EXPECT_TRUE(looks_by_cells(400, fraction));
  for (const double fraction : {0.004, 0.28, 0.3}) EXPECT_FALSE(looks_by_cells(400, fraction));
  EXPECT_FALSE(looks_by_cells(100, 0.1));
}

TEST(DiluteGas, HasListsWhereSpheresFallOrDifferMuch) {
  const Box box = box_of(400, 0.05, 0);
  const State start = support::random_gas(400, box.sides(), 1, 3);
  const Simulation<3, double> falling(
      Box(box.sides(), 0, box.cell_width()[0], 2), start, {1.0},
      {.acceleration = {{0, 0, -1}}, .walls = Walls<double>{.axis = 2}});
  EXPECT_FALSE(falling.looks_by_cells());
  State mixture = support::random_gas(400, box.sides(), 1, 3);
  mixture.grains.diameters.assign(400, 0.5);
  EXPECT_TRUE(Gas(box, mixture, {1.0}).looks_by_cells());
  mixture.grains.diameters.assign(400, 1);
  mixture.grains.diameters[0] = 1.8;  // would fill 1.8^3 x 0.05 = 0.29
  const Box with_room_for_it = box_of(400, 0.05, 0, 1.1);
  EXPECT_FALSE(Gas(with_room_for_it, mixture, {1.0}).looks_by_cells());
}

/// Rounding grows by up to twice the flight in each collision of a sphere: three of them at 0.05,
/// with flights of 2.4 in the mean, leave it far below 1e-9.
TEST(DiluteGas, CollidesAsWithLists) {
  constexpr std::int32_t spheres = 500;
  for (const double fraction : {0.02, 0.05, 0.1, 0.15, 0.2, 0.25}) {
    for (const double shear_rate : {0.0, 1.0}) {
      Gas gas = gas_of(spheres, box_of(spheres, fraction, shear_rate), 0.9);
      Gas with_lists = gas_of(spheres, box_of(spheres, fraction, shear_rate, 1.5), 0.9);
      ASSERT_TRUE(gas.looks_by_cells());
      ASSERT_FALSE(with_lists.looks_by_cells());
      SCOPED_TRACE(fraction);
      support::expect_like_collisions(gas, with_lists, 3 * spheres / 2, 1e-9);
    }
  }
}

/// The start of a gas in which two of three spheres rest, wholly or along one axis.
State mostly_at_rest(std::int32_t spheres, const Vector& sides) {
  State start = support::random_gas(spheres, sides, 1.5, 3);
  for (int i = 0; i < spheres; ++i) {
    auto& velocity = start.velocities[static_cast<std::size_t>(i)];
    if (i % 3 == 0) velocity = {0, -0.0, 0};
    if (i % 3 == 1) velocity[i % 9 / 3] = i % 2 == 0 ? 0.0 : -0.0;
  }
  return start;
}

TEST(DiluteGas, WhoseSpheresRestCollidesAsWithLists) {
  constexpr std::int32_t spheres = 500;
  for (const double shear_rate : {0.0, 1.0}) {
    const Box box = box_of(spheres, 0.1, shear_rate);
    const Box for_lists = box_of(spheres, 0.1, shear_rate, 1.5);
    const State start = mostly_at_rest(spheres, box.sides());
    Gas gas(box, start, {0.9});
    Gas with_lists(for_lists, start, {0.9});
    ASSERT_TRUE(gas.looks_by_cells());
    support::expect_like_collisions(gas, with_lists, spheres, 1e-9);
  }
}

TEST(DiluteGas, OfImmobileSpheresCollidesAsWithLists) {
  constexpr std::int32_t spheres = 500;
  State start = mostly_at_rest(spheres, box_of(spheres, 0.1, 0).sides());
  for (int i = 0; i < spheres; ++i) start.grains.immobile.push_back(i % 3 == 0 ? 1 : 0);
  Gas gas(box_of(spheres, 0.1, 0), start, {0.9});
  Gas with_lists(box_of(spheres, 0.1, 0, 1.5), start, {0.9});
  ASSERT_TRUE(gas.looks_by_cells());
  support::expect_like_collisions(gas, with_lists, spheres, 1e-9);
}

TEST(DiluteGas, ThatIsColdIsStirredByShearAlone) {
  const Box box = box_of(500, 0.05, 1);
  State start = support::random_gas(500, box.sides(), 1.5, 3);
  for (auto& velocity : start.velocities) velocity = {};
  Gas gas(box, start, {0.9});
  for (int n = 0; n < 1000; ++n) ASSERT_GT(support::next(gas).gap_before, -1e-9);
}

TEST(DiluteGas, OfDifferentSizesCollidesAsWithLists) {
  constexpr std::int32_t spheres = 500;
  for (const double shear_rate : {0.0, 1.0}) {
    State start = support::random_gas(spheres, box_of(spheres, 0.1, 0).sides(), 1.5, 3);
    support::Dice dice(4);
    for (int i = 0; i < spheres; ++i) start.grains.diameters.push_back(dice.between(0.5, 1));
    Gas gas(box_of(spheres, 0.1, shear_rate), start, {0.9});
    Gas with_lists(box_of(spheres, 0.1, shear_rate, 1.5), start, {0.9});
    ASSERT_TRUE(gas.looks_by_cells());
    ASSERT_FALSE(with_lists.looks_by_cells());
    support::expect_like_collisions(gas, with_lists, spheres, 1e-9);
  }
}

TEST(DiluteGas, MissesNoSphereInALongRun) {
  // What it has missed it meets later as an overlap.
  for (const double shear_rate : {0.0, 0.5}) {
    Gas gas = gas_of(400, box_of(400, 0.12, shear_rate), 0.95);
    for (int n = 0; n < 40'000; ++n) {
      const auto collision = support::next(gas);
      ASSERT_GT(collision.gap_before, -1e-9) << "collision " << collision.number;
    }
  }
}

TEST(DiluteGas, GoesOnFromAnArchiveBitForBit) {
  for (const double shear_rate : {0.0, 1.0}) {
    const Box box = box_of(300, 0.05, shear_rate);
    Gas gas = gas_of(300, box, 0.8);
    for (int part = 0; part < 3; ++part) {
      for (int n = 0; n < 333; ++n) support::next(gas);
      ArchiveWriter writer;
      gas.archive_to(writer);
      const Bytes bytes = writer.release();
      ArchiveReader reader(bytes);
      Gas again(box, gas.rules(), {}, reader);
      reader.require_end();
      EXPECT_TRUE(again.looks_by_cells());
      support::expect_same_collisions(gas, again, 333);
    }
  }
}

TEST(DiluteGas, GetsListsWhereItCrowdsTogether) {
  // 12^3 spheres on a lattice with 1.02 between them, in one corner of a box that they fill to
  // 0.03.
  constexpr int side = 12;
  constexpr std::int32_t spheres = side * side * side;
  for (const double shear_rate : {0.0, 1.0}) {
    const Box box = box_of(spheres, 0.03, shear_rate);
    State start = support::random_gas(spheres, {{200, 200, 200}}, 1, 3);
    for (int i = 0; i < spheres; ++i) {
      const std::array<int, 3> place{i % side, i / side % side, i / side / side};
      for (int axis = 0; axis < 3; ++axis) {
        start.positions[static_cast<std::size_t>(i)][axis] =
            1 + 1.02 * place[static_cast<std::size_t>(axis)];
      }
    }
    Gas gas(box, start, {0.9});
    const bool had_lists = !gas.looks_by_cells();
    for (int n = 0; n < 5000; ++n) ASSERT_GT(support::next(gas).gap_before, -1e-9);
    EXPECT_FALSE(had_lists);
    EXPECT_FALSE(gas.looks_by_cells());
    ArchiveWriter writer;
    gas.archive_to(writer);
    const Bytes bytes = writer.release();
    ArchiveReader reader(bytes);
    Gas again(box, gas.rules(), {}, reader);
    EXPECT_FALSE(again.looks_by_cells());
    support::expect_same_collisions(gas, again, 500);
  }
}

}  // namespace
}  // namespace zenosphere
