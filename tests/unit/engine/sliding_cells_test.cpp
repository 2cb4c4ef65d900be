#include "engine/sliding_cells.hpp"

#include <gtest/gtest.h>

#include <set>
#include <tuple>
#include <vector>

namespace zenosphere {
namespace {

using Cells = SlidingCells<3>;

const std::vector<Steps<3>> cell_shapes{{2, 2, 2}, {3, 3, 3}, {4, 4, 4}, {2, 4, 3},
                                        {4, 2, 2}, {3, 2, 5}, {5, 3, 2}, {5, 6, 4}};
/// Three columns of the own layer, five of the others: as far as a list under shear looks.
constexpr Cells::Reach wide_reach{{{-3, 1}, {-1, 1}, {-1, 3}}};

TEST(SlidingCells, CoordinatesAndNumbersAgree) {
  for (const Steps<3>& shape : cell_shapes) {
    const Cells cells(shape);
    for (std::int32_t cell = 0; cell < cells.count(); ++cell) {
      const Steps<3> coordinates = cells.coordinates(cell);
      for (std::size_t axis = 0; axis < 3; ++axis) ASSERT_LT(coordinates[axis], shape[axis]);
      ASSERT_EQ(cells.index(coordinates), cell);
    }
  }
}

/// The lag of a cell, found in an image, behind the place that is so many steps away.
Steps<3> missing(const Cells& cells, const Steps<3>& shape, const Steps<3>& home, std::int32_t cell,
                 PeriodicImage periodic_image, const Steps<3>& steps) {
  Steps<3> missing = cells.coordinates(cell);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    missing[axis] +=
        periodic_image.periods(static_cast<int>(axis)) * shape[axis] - home[axis] - steps[axis];
  }
  missing[0] += periodic_image.layers() * cells.whole_slide() +
                periodic_image.periods(1) * cells.whole_offset();
  return missing;
}

void expect_each_cell_around_once(const Cells& cells, const Steps<3>& shape) {
  for (std::int32_t from = 0; from < cells.count(); ++from) {
    const Steps<3> home = cells.coordinates(from);
    std::set<std::tuple<std::int32_t, std::int32_t>> found;
    std::set<Steps<3>> steps_found;
    cells.for_each_run(
        home, wide_reach,
        [&](std::int32_t first, std::int32_t last, PeriodicImage periodic_image, Steps<3> steps) {
          for (std::int32_t cell = first; cell <= last; ++cell, ++steps[0]) {
            ASSERT_EQ(missing(cells, shape, home, cell, periodic_image, steps), (Steps<3>{}));
            ASSERT_EQ(periodic_image.layers(), steps[1]);
            found.insert({cell, periodic_image.code()});
            steps_found.insert(steps);
          }
        });
    ASSERT_EQ(found.size(), 3u * (5 + 3 + 5));
    ASSERT_EQ(steps_found.size(), found.size());
  }
}

TEST(SlidingCells, RunsLeadToEachCellAroundOnceAndOnItsWay) {
  for (const Steps<3>& shape : cell_shapes) {
    for (const int offset : {0, -shape[0] / 2, (shape[0] - 1) / 2}) {
      Cells cells(shape);
      cells.displace_images(offset);
      for (int slid = 0; slid <= shape[0]; ++slid, cells.slide_by_one_cell()) {
        ASSERT_NO_FATAL_FAILURE(expect_each_cell_around_once(cells, shape)) << offset;
      }
      EXPECT_EQ(cells.whole_slide(), 1 % shape[0]);  // once around, and one more
    }
  }
}

TEST(SlidingCells, HaveNoLayersOnALine) {
  const SlidingCells<1> cells({4});
  std::vector<std::int32_t> found;
  cells.for_each_run({0}, {{{-1, 1}, {-1, 1}, {-1, 1}}},
                     [&](std::int32_t first, std::int32_t last, PeriodicImage, const Steps<1>&) {
                       for (std::int32_t cell = first; cell <= last; ++cell) found.push_back(cell);
                     });
  EXPECT_EQ(found, (std::vector<std::int32_t>{3, 0, 1}));
}

TEST(PeriodicImage, OfTheOtherSphereIsTheReverse) {
  const PeriodicImage periodic_image(Steps<3>{3, -1, 1}, -1);
  EXPECT_EQ(periodic_image.reversed(), PeriodicImage(Steps<3>{-3, 1, -1}, 1));
  EXPECT_EQ(periodic_image.reversed().reversed(), periodic_image);
  EXPECT_EQ(PeriodicImage().reversed(), PeriodicImage());
  EXPECT_EQ(periodic_image.periods(0), 3);
  EXPECT_EQ(periodic_image.periods(1), -1);
  EXPECT_EQ(periodic_image.periods(2), 1);
  EXPECT_EQ(periodic_image.layers(), -1);
}

TEST(PeriodicImage, AfterAWholeTurnLeadsThroughOneMoreBox) {
  EXPECT_EQ(PeriodicImage(Steps<3>{-1, 1, 0}, 1).after_whole_turn(),
            PeriodicImage(Steps<3>{0, 1, 0}, 1));
  EXPECT_EQ(PeriodicImage(Steps<3>{1, 0, 1}, -1).after_whole_turn(),
            PeriodicImage(Steps<3>{0, 0, 1}, -1));
  EXPECT_EQ(PeriodicImage(Steps<3>{1, 0, 1}, 0).after_whole_turn(),
            PeriodicImage(Steps<3>{1, 0, 1}, 0));
}

}  // namespace
}  // namespace zenosphere
