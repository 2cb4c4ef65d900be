#include "engine/neighbour_lists.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <map>
#include <set>
#include <vector>

#include "support/gas.hpp"

namespace zenosphere {
namespace {

using Set = std::set<std::uint32_t>;

Set listed(const NeighbourLists& lists, std::int32_t i) {
  Set all;
  for (const Neighbour neighbour : lists.of(i)) all.insert(neighbour.packed());
  return all;
}

std::vector<Neighbour> with_room(std::vector<Neighbour> neighbours) {
  neighbours.resize(neighbours.size() + 8);
  return neighbours;
}

/// Each sphere meets others at random, again and again; the lists are compared with sets.
void expect_agreement_with_sets(int spheres, int neighbours, int times) {
  support::Dice dice(7);
  NeighbourLists lists(spheres, 0);
  std::map<std::int32_t, Set> sets;
  for (int n = 0; n < times; ++n) {
    const std::int32_t i = dice.below(spheres);
    std::map<std::int32_t, Neighbour> chosen;
    for (int k = dice.below(neighbours + 1); k > 0; --k) {
      const std::int32_t j = dice.below(spheres);
      const PeriodicImage periodic_image(Steps<3>{dice.below(3) - 1, 0, dice.below(2)},
                                         dice.below(3) - 1);
      if (j != i) chosen.emplace(j, Neighbour(j, periodic_image));
    }
    std::vector<Neighbour> now;
    Set expected_new;
    for (const auto& [j, neighbour] : chosen) {
      now.push_back(neighbour);
      if (!sets[i].contains(neighbour.packed())) expected_new.insert(neighbour.packed());
    }
    for (const auto packed : sets[i]) {
      const auto old = Neighbour::from_packed(packed);
      sets[old.sphere()].erase(old.reversed(i).packed());
    }
    sets[i].clear();
    for (const Neighbour neighbour : now) {
      sets[i].insert(neighbour.packed());
      sets[neighbour.sphere()].insert(neighbour.reversed(i).packed());
    }
    const std::size_t count = now.size();
    now = with_room(now);
    const std::span<Neighbour> all = std::span(now).first(count);
    const NeighbourLists::Changes changes = lists.changes(i, all);
    lists.prefetch(i, all, changes);
    lists.replace(i, all, changes);
    Set found_new;
    for (std::size_t k = 0; k < changes.fresh; ++k) found_new.insert(now[k].packed());
    for (const auto packed : expected_new) ASSERT_TRUE(found_new.contains(packed));
    if (neighbours <= 64) {
      ASSERT_EQ(found_new, expected_new);
    }
    for (std::int32_t j = 0; j < spheres; ++j) ASSERT_EQ(listed(lists, j), sets[j]);
  }
}

TEST(NeighbourLists, AgreeWithSetsWhereListsAreShort) { expect_agreement_with_sets(12, 6, 2000); }

TEST(NeighbourLists, AgreeWithSetsWhereListsFillAFewRegistersAndMore) {
  expect_agreement_with_sets(60, 30, 1000);
}

TEST(NeighbourLists, AgreeWithSetsWhereListsAreLongerThanAWord) {
  expect_agreement_with_sets(150, 120, 300);
}

TEST(NeighbourLists, TellWhereANeighbourStandsOnEveryWay) {
  NeighbourLists lists(4, 10);
  const PeriodicImage there(Steps<3>{1, 0, 0}, 0);
  lists.add(0, {2, PeriodicImage()});
  lists.add(0, {1, there});
  lists.add(0, {2, there});
  EXPECT_EQ(lists.places(0, 2), 0b101u);
  EXPECT_EQ(lists.places(0, 1), 0b010u);
  EXPECT_EQ(lists.places(0, 3), 0u);
  EXPECT_EQ(lists.of(1)[0], Neighbour(0, there.reversed()));
}

TEST(NeighbourLists, TurnWithTheLayers) {
  NeighbourLists lists(2, 10);
  const PeriodicImage above(Steps<3>{-1, 0, 0}, 1);
  lists.add(0, {1, above});
  lists.turn();
  EXPECT_EQ(lists.of(0)[0].periodic_image(), above.after_whole_turn());
  EXPECT_EQ(lists.of(1)[0].periodic_image(), above.after_whole_turn().reversed());
}

TEST(NeighbourLists, AreAsLongAsTheyHaveToBe) {
  NeighbourLists lists(400, 1);
  for (std::int32_t j = 1; j < 400; ++j) lists.add(0, {j, PeriodicImage()});
  ASSERT_EQ(lists.of(0).size(), 399u);
  for (std::int32_t j = 1; j < 400; ++j) EXPECT_EQ(lists.of(j)[0], Neighbour(0, PeriodicImage()));
}

}  // namespace
}  // namespace zenosphere
