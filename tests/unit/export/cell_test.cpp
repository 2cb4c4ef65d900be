#include "export/cell.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "model/errors.hpp"

namespace zenosphere {
namespace {

Snapshot with_edges(std::vector<double> edges) {
  return {.step = 3, .time = 0, .positions = {}, .velocities = {}, .box_edges = std::move(edges)};
}

Cell sheared(double offset) {
  return cell_of(with_edges({8, 0, 0, offset, 5, 0, 0, 0, 6}), 3, std::nullopt, "out.h5");
}

TEST(Cell, HasTheSidesAndTheOffsetOfTheBox) {
  const Cell cell = sheared(-3);
  EXPECT_EQ(cell.origin, (std::array<double, 3>{0, 0, 0}));
  EXPECT_EQ(cell.sides, (std::array<double, 3>{8, 5, 6}));
  EXPECT_EQ(cell.tilt, -3);
  EXPECT_EQ(cell.periodic, (std::array<bool, 3>{true, true, true}));
}

TEST(Cell, OffsetOfMoreThanHalfASideBecomesTheNearestOfTheSameLattice) {
  EXPECT_EQ(sheared(7).tilt, -1);   // 7 - 8
  EXPECT_EQ(sheared(27).tilt, 3);   // 27 - 3 x 8
  EXPECT_EQ(sheared(-21).tilt, 3);  // -21 + 3 x 8
  EXPECT_EQ(sheared(-4).tilt, -4);  // half a side is always on the left
  EXPECT_EQ(sheared(4).tilt, -4);
  EXPECT_EQ(sheared(12).tilt, -4);
  EXPECT_EQ(sheared(-4 - 0x1p-50).tilt, 4 - 0x1p-50);  // an ulp beyond it
  EXPECT_EQ(sheared(3.5).tilt, 3.5);
}

TEST(Cell, AxesThatTheRunLacksAreOneDiameterThickAndClosed) {
  const Cell line = cell_of(with_edges({7}), 1, std::nullopt, "out.h5");
  EXPECT_EQ(line.sides, (std::array<double, 3>{7, 1, 1}));
  EXPECT_EQ(line.origin, (std::array<double, 3>{0, -0.5, -0.5}));
  EXPECT_EQ(line.periodic, (std::array<bool, 3>{true, false, false}));
  EXPECT_EQ(line.upper(1), 0.5);
  const Cell plane = cell_of(with_edges({7, 0, 1, 6}), 2, 1, "out.h5");  // walls along y
  EXPECT_EQ(plane.sides, (std::array<double, 3>{7, 6, 1}));
  EXPECT_EQ(plane.origin, (std::array<double, 3>{0, 0, -0.5}));
  EXPECT_EQ(plane.periodic, (std::array<bool, 3>{true, false, false}));
}

TEST(Cell, LeaningXIsTheImageBetweenTheLeaningSides) {
  const Cell right = sheared(3);  // at y = 2.5 the cell goes from 1.5 to 9.5
  EXPECT_EQ(right.leaning_x(3, 2.5), 3);
  EXPECT_EQ(right.leaning_x(1, 2.5), 9);
  EXPECT_EQ(right.leaning_x(1.5, 2.5), 1.5);
  const Cell left = sheared(-4);  // from -2 to 6
  EXPECT_EQ(left.leaning_x(5, 2.5), 5);
  EXPECT_EQ(left.leaning_x(7, 2.5), -1);
  EXPECT_EQ(sheared(0).leaning_x(7.9, 4.9), 7.9);
}

TEST(Cell, EdgesOfNoRunAreNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& edges : {std::vector<double>{0, 0, 0, 5},
                            {-8, 0, 0, 5},
                            {8, 1, 0, 5},
                            {8, 0, nan, 5},
                            {nan, 0, 0, 5}}) {
    EXPECT_THROW(cell_of(with_edges(edges), 2, std::nullopt, "out.h5"), InputError);
  }
  try {
    cell_of(with_edges({8, 2, 0, 5}), 2, std::nullopt, "out.h5");
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "out.h5: box edge xy = 2 at collision 3 (no box of a run has that); it is damaged");
  }
}

}  // namespace
}  // namespace zenosphere
