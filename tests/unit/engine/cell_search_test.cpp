#include "engine/cell_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "support/gas.hpp"

namespace zenosphere {
namespace {

using Cells = SlidingCells<3>;
using Search = CellSearch<3>;
/// Spheres, each in its image.
using Seen = std::multiset<std::uint32_t>;

constexpr Steps<3> crowd_shape{7, 4, 5};

struct Flow {
  bool slides;
  bool is_displaced;
  int whole_slide;
  int whole_offset;
};
const std::vector<Flow> crowd_flows{{false, false, 0, 0},
                                    {true, false, 0, 0},
                                    {true, false, 6, 0},
                                    {false, true, 0, -3},
                                    {true, true, 4, 2}};

Seen seen(std::span<const Neighbour> neighbours) {
  Seen seen;
  for (const Neighbour neighbour : neighbours) {
    seen.insert(static_cast<std::uint32_t>(neighbour.sphere()));
  }
  return seen;
}

Seen new_in(const Seen& after, const Seen& before) {
  Seen fresh;
  std::set_difference(after.begin(), after.end(), before.begin(), before.end(),
                      std::inserter(fresh, fresh.end()));
  return fresh;
}

/// 400 spheres in 140 cells, three in the mean: in many more than have places there.
struct Crowd {
  explicit Crowd(const Flow& flow)
      : cells(crowd_shape), search(crowd_shape, 400, {flow.slides, false}) {
    cells.slide_to(flow.whole_slide);
    cells.displace_images(flow.whole_offset);
    if (flow.is_displaced) search.displace_images();
    support::Dice dice(5);
    for (std::int32_t i = 0; i < 400; ++i) {
      cell_of.push_back(dice.below(cells.count()));
      search.insert(i, cells.coordinates(cell_of.back()));
    }
  }
  void move(std::int32_t sphere, std::int32_t from, std::int32_t to) {
    search.remove(sphere, cells.coordinates(from));
    search.insert(sphere, cells.coordinates(to));
  }
  Seen around(const Steps<3>& home) const { return seen(search.around(cells, home)); }

  Cells cells;
  Search search;
  std::vector<std::int32_t> cell_of;
};

template <class Action>
void for_each_cell(const Crowd& crowd, Action action) {
  for (std::int32_t cell = 0; cell < crowd.cells.count(); ++cell) {
    action(crowd.cells.coordinates(cell));
  }
}

TEST(CellSearch, SeesAllInTheCellsAroundOnce) {
  const Crowd crowd({false, false, 0, 0});
  for_each_cell(crowd, [&](const Steps<3>& home) {
    Seen expected;
    for (std::int32_t i = 0; i < 400; ++i) {
      const Steps<3> there = crowd.cells.coordinates(crowd.cell_of[static_cast<std::size_t>(i)]);
      bool is_near = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const int apart = std::abs(there[axis] - home[axis]);
        is_near = is_near && std::min(apart, crowd_shape[axis] - apart) <= 1;
      }
      if (is_near) expected.insert(static_cast<std::uint32_t>(i));
    }
    EXPECT_EQ(crowd.around(home), expected);
  });
}

TEST(CellSearch, TellsAtEachFaceJustWhomASphereHasNotSeen) {
  for (const Flow& flow : crowd_flows) {
    const Crowd crowd(flow);
    for_each_cell(crowd, [&](const Steps<3>& from) {
      const Seen before = crowd.around(from);
      const auto expect_new = [&](int axis, int direction, const Steps<3>& to) {
        const Seen fresh = seen(crowd.search.beyond(crowd.cells, {axis, direction, from, to}));
        EXPECT_EQ(fresh, new_in(crowd.around(to), before)) << "axis " << axis;
      };
      for (const int direction : {-1, 1}) {
        for (const int axis : {0, 2}) {
          const auto a = static_cast<std::size_t>(axis);
          Steps<3> to = from;
          to[a] = (from[a] + direction + crowd_shape[a]) % crowd_shape[a];
          expect_new(axis, direction, to);
        }
        // Into any column of the next layer that may lie beyond the face.
        const int y = from[1] + direction;
        const int periods = y < 0 ? -1 : y == crowd_shape[1] ? 1 : 0;
        const int beside = from[0] - direction * flow.whole_slide - periods * flow.whole_offset;
        const auto columns =
            crowd.search.reach(crowd.cells, from)[static_cast<std::size_t>(1 + direction)];
        for (int step = columns.from + 1; step < columns.to; ++step) {
          const int column = ((beside + step) % crowd_shape[0] + crowd_shape[0]) % crowd_shape[0];
          expect_new(1, direction, {column, y - periods * crowd_shape[1], from[2]});
        }
      }
    });
  }
}

TEST(CellSearch, TellsOneOfEachPairThatLayersBringTogether) {
  for (const Flow& flow : crowd_flows) {
    if (!flow.slides) continue;
    Crowd crowd(flow);
    const auto all_around = [&] {
      std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
      for (std::uint32_t i = 0; i < 400; ++i) {
        for (const auto j : crowd.around(crowd.cells.coordinates(crowd.cell_of[i]))) {
          pairs.insert({i, j});
        }
      }
      return pairs;
    };
    const auto before = all_around();
    crowd.cells.slide_by_one_cell();
    std::multiset<std::pair<std::uint32_t, std::uint32_t>> told;
    for (std::uint32_t i = 0; i < 400; ++i) {
      const Steps<3> home = crowd.cells.coordinates(crowd.cell_of[i]);
      for (const auto j : seen(crowd.search.slid_near(crowd.cells, home))) told.insert({i, j});
    }
    int fresh = 0;
    for (const auto& [i, j] : all_around()) {
      if (before.count({i, j}) != 0) continue;
      ++fresh;
      EXPECT_EQ(told.count({i, j}) + told.count({j, i}), 1u);
    }
    EXPECT_EQ(static_cast<std::size_t>(fresh), 2 * told.size());
  }
}

TEST(CellSearch, FindsTheWayOnWhichASphereIsSeen) {
  for (const Flow& flow : crowd_flows) {
    const Crowd crowd(flow);
    for_each_cell(crowd, [&](const Steps<3>& home) {
      std::size_t image_count = 0;
      for (const Neighbour neighbour : crowd.search.around(crowd.cells, home)) {
        const auto cell = crowd.cell_of[static_cast<std::size_t>(neighbour.sphere())];
        const auto periodic_image =
            crowd.search.periodic_image(crowd.cells, home, crowd.cells.coordinates(cell));
        ASSERT_TRUE(periodic_image);
        EXPECT_EQ(*periodic_image, neighbour.periodic_image());
      }
      for (const auto cell : crowd.cell_of) {
        image_count +=
            crowd.search.periodic_image(crowd.cells, home, crowd.cells.coordinates(cell)) ? 1 : 0;
      }
      EXPECT_EQ(image_count, crowd.around(home).size());
    });
  }
}

TEST(CellSearch, ForgetsWhoHasMovedAway) {
  Crowd crowd({false, false, 0, 0});
  for (std::int32_t i = 0; i < 400; ++i) {
    crowd.move(i, crowd.cell_of[static_cast<std::size_t>(i)], 0);
  }
  EXPECT_EQ(crowd.around({0, 0, 0}).size(), 400u);
  EXPECT_TRUE(crowd.around({3, 2, 2}).empty());
  for (std::int32_t i = 0; i < 400; ++i) {
    crowd.move(i, 0, crowd.cell_of[static_cast<std::size_t>(i)]);
  }
  for_each_cell(crowd, [&](const Steps<3>& home) {
    EXPECT_EQ(crowd.around(home), Crowd({false, false, 0, 0}).around(home));
  });
}

}  // namespace
}  // namespace zenosphere
