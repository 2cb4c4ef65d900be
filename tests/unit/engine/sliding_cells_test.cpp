#include "engine/sliding_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "support/gas.hpp"

namespace zenosphere {
namespace {

using Cells = SlidingCells<3>;

/// The single steps that the rows of a stencil stand for.
std::vector<Steps<3>> ways(const Cells::Stencil& stencil) {
  std::vector<Steps<3>> all;
  for (const Cells::Row& row : stencil) {
    Steps<3> steps = row.steps;
    for (steps[0] = row.from; steps[0] <= row.to; ++steps[0]) all.push_back(steps);
  }
  return all;
}
using support::Vector;

const std::vector<Steps<3>> kShapes{{2, 2, 2}, {3, 3, 3}, {4, 4, 4}, {2, 4, 3},
                                    {4, 2, 2}, {3, 2, 5}, {5, 3, 2}, {5, 6, 4}};

bool contains(const std::vector<Steps<3>>& stencil, const Steps<3>& steps) {
  return std::find(stencil.begin(), stencil.end(), steps) != stencil.end();
}

/// A place in a cell of unit width, in the frame of its layer.
struct Place {
  std::int32_t cell;
  Vector in_layer;
};

Place some_place(const Cells& cells, support::Dice& dice) {
  Place place{dice.below(cells.count()), {}};
  for (int axis = 0; axis < 3; ++axis) {
    place.in_layer[axis] =
        cells.coordinates(place.cell)[static_cast<std::size_t>(axis)] + dice.between(0, 1);
  }
  return place;
}

/// All ways from a to images of b that are closer than a cell is wide, in the laboratory frame.
///
/// Layer k is displaced by k slides, and so is the upper image of the box by all its layers.
std::vector<Vector> near_images(const Cells& cells, const Steps<3>& shape, const Place& a,
                                const Place& b, double slide) {
  std::vector<Vector> ways;
  Vector dr = b.in_layer - a.in_layer;
  dr[0] += slide * (cells.coordinates(b.cell)[1] - cells.coordinates(a.cell)[1]);
  for (const int up : {-1, 0, 1}) {
    const double x = dr[0] + up * shape[1] * slide;
    for (const int turn : {-1, 0, 1}) {
      for (const int z : {-1, 0, 1}) {
        const Vector way{{x + (turn - std::round(x / shape[0])) * shape[0], dr[1] + up * shape[1],
                          dr[2] + z * shape[2]}};
        if (dot(way, way) < 1) ways.push_back(way);
      }
    }
  }
  return ways;
}

/// How often the neighbourhood of a holds b in the image at `way`.
int times_seen(const Cells& cells, const Place& a, const Place& b, const Vector& way,
               double fraction) {
  int seen = 0;
  for (const Steps<3>& steps : ways(cells.neighbourhood())) {
    const auto neighbour = cells.neighbour(a.cell, steps);
    if (neighbour.cell != b.cell) continue;
    Vector dr = b.in_layer - a.in_layer;
    for (int axis = 0; axis < 3; ++axis) dr[axis] += neighbour.lag[static_cast<std::size_t>(axis)];
    dr[0] += Cells::layers(steps) * fraction;
    if (dot(dr - way, dr - way) < 1e-20) ++seen;
  }
  return seen;
}

TEST(SlidingCells, NeighbourhoodHoldsEverySphereWithinReachOnce) {
  support::Dice dice(1);
  for (const Steps<3>& shape : kShapes) {
    Cells cells(shape, true, 1);
    int pairs = 0;
    for (int whole = 0; whole < 2 * shape[0] * shape[1] + 1; ++whole) {
      for (int n = 0; n < 300; ++n) {
        const double fraction = dice.below(8) == 0 ? 0.999999 : dice.between(0, 1);
        const Place a = some_place(cells, dice);
        const Place b = some_place(cells, dice);
        for (const Vector& way : near_images(cells, shape, a, b, whole + fraction)) {
          ASSERT_EQ(times_seen(cells, a, b, way, fraction), 1) << shape[0] << shape[1] << shape[2];
          ++pairs;
        }
      }
      cells.slide_by_one_cell();
    }
    EXPECT_GT(pairs, 100);
  }
}

TEST(SlidingCells, NeighbourhoodWithoutSlidingHoldsEverySphereWithinReachOnce) {
  support::Dice dice(2);
  for (const Steps<3>& shape : kShapes) {
    const Cells cells(shape, false, 1);
    for (int n = 0; n < 3000; ++n) {
      const Place a = some_place(cells, dice);
      const Place b = some_place(cells, dice);
      for (const Vector& way : near_images(cells, shape, a, b, 0)) {
        ASSERT_EQ(times_seen(cells, a, b, way, 0), 1);
      }
    }
  }
}

TEST(SlidingCells, NeighbourhoodHasThreeCellsOfTheOwnRowsAndFourOfTheAdjacent) {
  // Three rows along z in each of three layers: 3 x 3 + 2 x 3 x 4 = 33; without sliding 27.
  EXPECT_EQ(ways(Cells({5, 5, 5}, true, 1).neighbourhood()).size(), 33u);
  EXPECT_EQ(ways(Cells({5, 5, 5}, false, 1).neighbourhood()).size(), 27u);
}

TEST(SlidingCells, NeighbourOfALayerThatSlidToTheRightIsFurtherLeft) {
  Cells cells({5, 4, 3}, true, 1);
  const std::int32_t start = cells.index({2, 3, 1});
  EXPECT_EQ(cells.neighbour(start, {0, 1, 0}).cell,
            cells.index({2, 0, 1}));  // through the upper face
  cells.slide_by_one_cell();
  EXPECT_EQ(cells.neighbour(start, {0, 1, 0}).cell, cells.index({1, 0, 1}));
  EXPECT_EQ(cells.neighbour(start, {0, -1, 0}).cell, cells.index({3, 2, 1}));
  EXPECT_EQ(cells.neighbour(start, {1, 0, -1}).cell, cells.index({3, 3, 0}));
  for (int n = 0; n < 4; ++n) cells.slide_by_one_cell();  // five in all: once round the row
  EXPECT_EQ(cells.neighbour(start, {0, 1, 0}).cell, cells.index({2, 0, 1}));
}

TEST(SlidingCells, LagIsWhatTheCoordinatesLack) {
  Cells cells({5, 4, 3}, true, 1);
  cells.slide_by_one_cell();
  // From column 0, layer 3 one layer up: layer 0 (4 layers lacking); its column 4 lies above,
  // one to the left of column 0 through the face: the difference 4 lacks -4 of the way 0.
  const std::int32_t from = cells.index({0, 3, 1});
  const std::int32_t to = cells.index({4, 0, 1});
  const auto neighbour = cells.neighbour(from, {0, 1, 0});
  EXPECT_EQ(neighbour.cell, to);
  EXPECT_EQ(neighbour.lag, (Steps<3>{-4, 4, 0}));
  EXPECT_EQ(cells.lag(from, to, {0, 1, 0}), (Steps<3>{-4, 4, 0}));
  // Once more round the box along x: five columns more are lacking.
  EXPECT_EQ(cells.lag(from, to, {5, 1, 0}), (Steps<3>{1, 4, 0}));
}

/// Whether steps_between() leads from one cell to the other along every axis, and not further than
/// half round the box, for a way of `layers` up.
void expect_short_way(const Cells& cells, const Steps<3>& shape, std::int32_t from, std::int32_t to,
                      int layers, int whole_slide) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const int steps = cells.steps_between(from, to, axis, layers);
    ASSERT_GE(2 * steps, -shape[a]);
    ASSERT_LT(2 * steps, shape[a]);
    const int slid = axis == 0 ? layers * whole_slide : 0;
    ASSERT_EQ((cells.coordinates(from)[a] + steps - slid - cells.coordinates(to)[a]) % shape[a], 0);
  }
}

TEST(SlidingCells, StepsBetweenLeadToTheCellByAShortWay) {
  for (const Steps<3>& shape : kShapes) {
    Cells cells(shape, true, 1);
    for (int whole = 0; whole <= shape[0]; ++whole) {
      for (std::int32_t from = 0; from < cells.count(); ++from) {
        for (std::int32_t to = 0; to < cells.count(); ++to) {
          for (const int layers : {-2, -1, 0, 1, 2}) {
            expect_short_way(cells, shape, from, to, layers, whole);
          }
        }
      }
      cells.slide_by_one_cell();
    }
  }
}

/// Ways of a crossing: under shear a sphere can arrive in two columns of the adjacent layer.
std::vector<Steps<3>> crossings(int axis, int direction, bool sliding) {
  Steps<3> straight{};
  straight[static_cast<std::size_t>(axis)] = direction;
  if (axis != 1 || !sliding) return {straight};
  return {straight, {-direction, direction, 0}};
}

TEST(SlidingCells, NewAfterCrossingHoldsAllThatWasNotSeenBefore) {
  for (const bool sliding : {false, true}) {
    const Cells cells({7, 7, 7}, sliding, 1);
    for (const int axis : {0, 1, 2}) {
      for (const int direction : {-1, 1}) {
        const auto found = ways(cells.new_after_crossing(axis, direction));
        for (const Steps<3>& way : crossings(axis, direction, sliding)) {
          for (const Steps<3>& steps : ways(cells.neighbourhood())) {
            // Seen from the cell before the crossing, the ways add up.
            const Steps<3> before{way[0] + steps[0], way[1] + steps[1], way[2] + steps[2]};
            if (!contains(ways(cells.neighbourhood()), before)) {
              EXPECT_TRUE(contains(found, steps)) << axis << ' ' << steps[0] << ' ' << steps[1];
            }
          }
        }
        for (const Steps<3>& steps : found) {
          EXPECT_TRUE(contains(ways(cells.neighbourhood()), steps));
        }
        EXPECT_LT(found.size(), ways(cells.neighbourhood()).size());
      }
    }
  }
}

TEST(SlidingCells, NewAfterSlideIsExactlyWhatWasNotSeenBefore) {
  const Cells cells({7, 7, 7}, true, 1);
  int expected = 0;
  for (const Steps<3>& steps : ways(cells.neighbourhood())) {
    // A cell of the layer above that is now at column d was at d - 1, below at d + 1.
    const Steps<3> before{steps[0] - steps[1], steps[1], steps[2]};
    const bool is_new = !contains(ways(cells.neighbourhood()), before);
    EXPECT_EQ(contains(ways(cells.new_after_slide()), steps), is_new);
    expected += is_new;
  }
  EXPECT_EQ(expected, 6);  // one column of three rows, above and below
  EXPECT_TRUE(Cells({7, 7, 7}, false, 1).new_after_slide().empty());
}

TEST(SlidingCells, KnowWhichSpheresAreInACell) {
  Cells cells({3, 3, 3}, true, 4);
  const auto spheres_of = [&](std::int32_t cell) {
    std::set<std::int32_t> spheres;
    for (auto id = cells.first(cell); id != Cells::kNone; id = cells.next(id)) spheres.insert(id);
    return spheres;
  };
  for (const std::int32_t sphere : {0, 1, 2}) cells.insert(sphere, 5);
  cells.insert(3, 6);
  cells.remove(1, 5);  // from the middle of the list
  EXPECT_EQ(spheres_of(5), (std::set<std::int32_t>{0, 2}));
  cells.remove(2, 5);  // its head
  cells.insert(2, 6);
  EXPECT_EQ(spheres_of(5), (std::set<std::int32_t>{0}));
  EXPECT_EQ(spheres_of(6), (std::set<std::int32_t>{2, 3}));
  cells.remove(0, 5);
  EXPECT_TRUE(spheres_of(5).empty());
}

TEST(SlidingCells, RunsOfARowAreItsNeighboursWithTheirLag) {
  for (const int side : {2, 3, 5}) {
    Cells cells({side, side, side}, true, 1);
    cells.slide_by_one_cell();
    for (std::int32_t cell = 0; cell < cells.count(); ++cell) {
      for (const Cells::Row& row : cells.neighbourhood()) {
        Steps<3> steps = row.steps;
        steps[0] = row.from;
        cells.for_each_run(cell, row,
                           [&](std::int32_t first, std::int32_t last, const Steps<3>& lag) {
                             for (std::int32_t found = first; found <= last; ++found, ++steps[0]) {
                               const auto neighbour = cells.neighbour(cell, steps);
                               EXPECT_EQ(found, neighbour.cell);
                               EXPECT_EQ(lag, neighbour.lag);
                             }
                           });
        EXPECT_EQ(steps[0], row.to + 1);
      }
    }
  }
}

}  // namespace
}  // namespace zenosphere
