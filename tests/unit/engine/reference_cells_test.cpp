#include "engine/reference_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "support/gas.hpp"

namespace zenosphere {
namespace {

constexpr int cells_in_row = 4;
constexpr int row_width = 5000;  // grains, along x

struct Place {
  std::int32_t cell;
  ReferencePosition reference;
};

/// The same search along all cells, one by one.
std::set<std::int32_t> within(const std::vector<Place>& places, const ReferenceCells::Row& row,
                              std::int32_t square) {
  std::set<std::int32_t> found;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& [cell, reference] = places[i];
    const int dx = std::abs(reference.place[0] + cell * row_width - row.place[0]);
    const int along = std::max(0, dx - row.slide);
    const int dy = reference.place[1] - row.place[1];
    const int dz = reference.place[2] - row.place[2];
    if (along * along + dy * dy + dz * dz < square) {
      found.insert(static_cast<std::int32_t>(i));
    }
  }
  return found;
}

void expect_agreement(int spheres) {
  support::Dice dice(5);
  const auto somewhere = [&](int from, int to) {
    return static_cast<std::int16_t>(from + dice.below(to - from));
  };
  ReferenceCells cells(cells_in_row);
  std::vector<Place> places;
  for (std::int32_t i = 0; i < spheres; ++i) {
    places.push_back({dice.below(cells_in_row), {}});
    places.back().reference.place = {somewhere(0, row_width), somewhere(0, 6000),
                                     somewhere(0, 6000)};
    cells.insert(i, places.back().cell, places.back().reference);
  }
  const PeriodicImage periodic_image(Steps<3>{1, 0, -1}, 1);
  const PeriodicImage another_image(Steps<3>{0, 1, 0}, 0);
  for (int n = 0; n < 300; ++n) {
    const std::int32_t moved = dice.below(spheres);
    Place& place = places[static_cast<std::size_t>(moved)];
    cells.remove(moved, place.cell);
    place.cell = dice.below(cells_in_row);
    cells.insert(moved, place.cell, place.reference);

    const ReferenceCells::Row row{.first = 0,
                                  .last = cells_in_row - 1,
                                  .periodic_image = periodic_image,
                                  .place = {somewhere(-row_width, 2 * row_width),
                                            somewhere(-6000, 12000), somewhere(-6000, 12000)},
                                  .slide = somewhere(0, n % 2 == 0 ? 1 : 2000)};
    std::array<ReferenceCells::Row, 2> halves{row, row};
    halves[0].last = 1;
    halves[1].first = 2;
    halves[1].place[0] -= 2 * row_width;
    halves[1].periodic_image = another_image;
    const ReferenceCells::Range range{dice.below(36000000), row_width};
    std::vector<Neighbour> found(cells_in_row * cells.room() + ReferenceCells::slack);
    const Neighbour* const end = cells.find(halves, range, found.data());
    std::set<std::int32_t> spheres_found;
    for (const Neighbour* one = found.data(); one != end; ++one) {
      const std::int32_t cell = places[static_cast<std::size_t>(one->sphere())].cell;
      ASSERT_EQ(one->periodic_image(), cell < 2 ? periodic_image : another_image);
      ASSERT_TRUE(spheres_found.insert(one->sphere()).second);
    }
    ASSERT_EQ(spheres_found, within(places, row, range.square));
  }
}

TEST(ReferenceCells, FindWhatIsWithinADistance) { expect_agreement(10); }

TEST(ReferenceCells, FindItInCrowdedCells) { expect_agreement(120); }

TEST(ReferenceCells, FindNothingInEmptyCells) {
  const ReferenceCells cells(cells_in_row);
  for (const auto x : {std::int16_t{-9000}, std::int16_t{0}, std::int16_t{24000}}) {
    std::vector<Neighbour> found(cells_in_row * cells.room() + ReferenceCells::slack);
    const std::array<ReferenceCells::Row, 1> row{
        {{0, cells_in_row - 1, PeriodicImage(), {x, 0, 0}, 1500}}};
    EXPECT_EQ(cells.find(row, ReferenceCells::Range{6000 * 6000, row_width}, found.data()),
              found.data());
  }
}

}  // namespace
}  // namespace zenosphere
