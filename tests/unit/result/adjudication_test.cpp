#include "result/adjudication.hpp"

#include <gtest/gtest.h>

namespace zenosphere {
namespace {

JudgedApproach approach_of(std::vector<std::int32_t> spheres, Finding finding) {
  return {.finding = finding,
          .spheres = std::move(spheres),
          .first_collision = 70,
          .first_time = "0.25"};
}

TEST(AddDistinct, KeepsAnApproachThatTwoGroupsOfHitsLeadToOnce) {
  std::vector<JudgedApproach> all{approach_of({0, 1, 2}, Finding::singular)};
  add_distinct({approach_of({0, 1, 2}, Finding::singular)}, all);
  EXPECT_EQ(all.size(), 1u);
  add_distinct({approach_of({0, 1, 3}, Finding::singular)}, all);
  EXPECT_EQ(all.size(), 2u);
}

TEST(AddDistinct, KeepsBothWhereTheSameSpheresAreJudgedInTwoWays) {
  std::vector<JudgedApproach> all{approach_of({0, 1, 2}, Finding::near_collapse)};
  add_distinct({approach_of({0, 1, 2}, Finding::singular)}, all);
  EXPECT_EQ(all.size(), 2u);
}

TEST(Refuted, ApproachIsANearCollapseWithoutATimeOfCollapse) {
  JudgedApproach approach = approach_of({0, 1, 2}, Finding::singular);
  approach.collapse_time = "3.636";
  approach.uncertainty = 1e-50;
  refute(approach, "the rods part again");
  EXPECT_EQ(approach.finding, Finding::near_collapse);
  EXPECT_FALSE(approach.collapse_time || approach.uncertainty);
  EXPECT_EQ(approach.sentence, "the rods part again");
}

}  // namespace
}  // namespace zenosphere
