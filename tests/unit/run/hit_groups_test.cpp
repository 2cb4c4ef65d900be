#include "run/hit_groups.hpp"

#include <gtest/gtest.h>

namespace zenosphere {
namespace {

DepthRow at_limit(std::int32_t i, std::int32_t j) { return {i, j, 16, true}; }

TEST(HitGroups, HitsOfTheSameSpheresSoonAfterEachOtherAreOneGroup) {
  HitGroups groups(10);
  groups.observe_hit(100, 1.0, at_limit(0, 1));
  groups.observe_hit(102, 1.0, at_limit(1, 2));
  ASSERT_EQ(groups.groups().size(), 1u);
  const HitGroup group = groups.groups().front();
  EXPECT_EQ(group.spheres, (std::vector<std::int32_t>{0, 1, 2}));
  EXPECT_EQ(group.hits, 2);
  EXPECT_EQ(group.first_hit, 100);
  EXPECT_EQ(group.last_hit, 102);
}

TEST(HitGroups, OtherSpheresAreAnotherGroup) {
  HitGroups groups(10);
  groups.observe_hit(100, 1.0, at_limit(0, 1));
  groups.observe_hit(101, 1.0, at_limit(2, 3));
  EXPECT_EQ(groups.groups().size(), 2u);
}

TEST(HitGroups, HitBetweenTwoGroupsJoinsThem) {
  HitGroups groups(10);
  groups.observe_hit(100, 1.0, at_limit(0, 1));
  groups.observe_hit(101, 1.0, at_limit(2, 3));
  groups.observe_hit(102, 1.0, at_limit(1, 2));
  ASSERT_EQ(groups.groups().size(), 1u);
  EXPECT_EQ(groups.groups().front().spheres, (std::vector<std::int32_t>{0, 1, 2, 3}));
  EXPECT_EQ(groups.groups().front().first_hit, 100);
}

TEST(HitGroups, JoinedGroupsBeginWithTheOneThatBeganFirst) {
  HitGroups groups(10);
  groups.observe(80, {2, 3, 9, false});
  groups.observe_hit(100, 1.0, at_limit(0, 1));
  groups.observe_hit(101, 1.0, at_limit(2, 3));
  groups.observe_hit(102, 1.0, at_limit(1, 2));
  ASSERT_EQ(groups.groups().size(), 1u);
  EXPECT_EQ(groups.groups().front().from, 78);  // one before the collision before the gap of 1e-9
}

TEST(HitGroups, SameSpheresLongAfterAreAnotherGroup) {
  HitGroups groups(10);
  groups.observe_hit(100, 1.0, at_limit(0, 1));
  groups.observe_hit(200, 2.0, at_limit(0, 1));  // between collisions of a sphere: 2 x 10/400
  EXPECT_EQ(groups.groups().size(), 2u);
}

TEST(HitGroups, WallConnectsNoSpheres) {
  HitGroups groups(2);
  groups.observe_hit(100, 1.0, at_limit(0, 2));
  groups.observe_hit(101, 1.0, at_limit(1, 2));
  EXPECT_EQ(groups.groups().size(), 2u);
}

TEST(HitGroups, GroupBeginsBeforeTheSmallGapsThatLedToIt) {
  HitGroups groups(10);
  groups.observe(90, {0, 1, 3, false});
  groups.observe(91, {1, 2, 9, false});
  groups.observe(92, {5, 6, 9, false});
  groups.observe(93, {0, 1, 12, false});
  groups.observe_hit(93, 1.0, at_limit(1, 2));
  const HitGroup group = groups.groups().front();
  EXPECT_EQ(group.from, 89);  // one before the collision before the gap of 1e-9
  EXPECT_EQ(group.spheres, (std::vector<std::int32_t>{0, 1, 2}));
}

}  // namespace
}  // namespace zenosphere
