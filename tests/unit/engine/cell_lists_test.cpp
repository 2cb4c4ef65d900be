#include "engine/cell_lists.hpp"

#include <gtest/gtest.h>

#include <set>

namespace zenosphere {
namespace {

TEST(CellLists, KnowWhichSpheresAreInACell) {
  CellLists lists(27, 4);
  const auto spheres_of = [&](std::int32_t cell) {
    std::set<std::int32_t> spheres;
    for (auto id = lists.first(cell); id != CellLists::none; id = lists.next(id)) {
      spheres.insert(id);
    }
    return spheres;
  };
  for (const std::int32_t sphere : {0, 1, 2}) lists.insert(sphere, 5);
  lists.insert(3, 6);
  lists.remove(1, 5);  // from the middle of the list
  EXPECT_EQ(spheres_of(5), (std::set<std::int32_t>{0, 2}));
  lists.remove(2, 5);  // its head
  lists.insert(2, 6);
  EXPECT_EQ(spheres_of(5), (std::set<std::int32_t>{0}));
  EXPECT_EQ(spheres_of(6), (std::set<std::int32_t>{2, 3}));
  lists.remove(0, 5);
  EXPECT_TRUE(spheres_of(5).empty());
}

}  // namespace
}  // namespace zenosphere
