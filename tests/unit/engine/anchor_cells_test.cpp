#include "engine/anchor_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "support/gas.hpp"

namespace zenosphere {
namespace {

constexpr int kCells = 4;
constexpr int kWidth = 5000;  // grains, along x

struct Place {
  std::int32_t cell;
  Anchor anchor;
};

/// The same search along all cells, one by one.
std::set<std::int32_t> within(const std::vector<Place>& places, const AnchorCells::Row& row,
                              std::int32_t square) {
  std::set<std::int32_t> found;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& [cell, anchor] = places[i];
    const int dx = std::abs(anchor.place[0] + cell * kWidth - row.place[0]);
    const int along = std::max(0, dx - row.slide);
    const int dy = anchor.place[1] - row.place[1];
    const int dz = anchor.place[2] - row.place[2];
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
  AnchorCells cells(kCells);
  std::vector<Place> places;
  for (std::int32_t i = 0; i < spheres; ++i) {
    places.push_back({dice.below(kCells), {}});
    places.back().anchor.place = {somewhere(0, kWidth), somewhere(0, 6000), somewhere(0, 6000)};
    cells.insert(i, places.back().cell, places.back().anchor);
  }
  const Way way(Steps<3>{1, 0, -1}, 1);
  const Way another_way(Steps<3>{0, 1, 0}, 0);
  for (int n = 0; n < 300; ++n) {
    const std::int32_t moved = dice.below(spheres);
    Place& place = places[static_cast<std::size_t>(moved)];
    cells.remove(moved, place.cell);
    place.cell = dice.below(kCells);
    cells.insert(moved, place.cell, place.anchor);

    const AnchorCells::Row row{
        .first = 0,
        .last = kCells - 1,
        .way = way,
        .place = {somewhere(-kWidth, 2 * kWidth), somewhere(-6000, 12000), somewhere(-6000, 12000)},
        .slide = somewhere(0, n % 2 == 0 ? 1 : 2000)};
    std::array<AnchorCells::Row, 2> halves{row, row};
    halves[0].last = 1;
    halves[1].first = 2;
    halves[1].place[0] -= 2 * kWidth;
    halves[1].way = another_way;
    const AnchorCells::Range range{dice.below(36000000), kWidth};
    std::vector<Neighbour> found(kCells * cells.room() + AnchorCells::slack);
    const Neighbour* const end = cells.find(halves, range, found.data());
    std::set<std::int32_t> spheres_found;
    for (const Neighbour* one = found.data(); one != end; ++one) {
      const std::int32_t cell = places[static_cast<std::size_t>(one->sphere())].cell;
      ASSERT_EQ(one->way(), cell < 2 ? way : another_way);
      ASSERT_TRUE(spheres_found.insert(one->sphere()).second);
    }
    ASSERT_EQ(spheres_found, within(places, row, range.square));
  }
}

TEST(AnchorCells, FindWhatIsWithinADistance) { expect_agreement(10); }

TEST(AnchorCells, FindItInCrowdedCells) { expect_agreement(120); }

TEST(AnchorCells, FindNobodyInEmptyCells) {
  const AnchorCells cells(kCells);
  for (const auto x : {std::int16_t{-9000}, std::int16_t{0}, std::int16_t{24000}}) {
    std::vector<Neighbour> found(kCells * cells.room() + AnchorCells::slack);
    const std::array<AnchorCells::Row, 1> row{{{0, kCells - 1, Way(), {x, 0, 0}, 1500}}};
    EXPECT_EQ(cells.find(row, AnchorCells::Range{6000 * 6000, kWidth}, found.data()), found.data());
  }
}

}  // namespace
}  // namespace zenosphere
