#include "engine/rest.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace zenosphere {
namespace {

using Disks = System<2, double>;

/// Two disks in a box of 20 x 20 that fly straight.
Disks disks(const Vec<2, double>& from, const Vec<2, double>& speed_of_first,
            const Vec<2, double>& speed_of_second, double shear_rate = 0) {
  return Disks(ShearBox<2, double>({20, 20}, shear_rate),
               {{{4, 4}, from}, {speed_of_first, speed_of_second}}, {});
}

TEST(Rest, SpheresMoveAsOneUpToTheRoundingOfTheirVelocities) {
  constexpr double ulp = std::numeric_limits<double>::epsilon();
  EXPECT_TRUE(move_as_one(disks({8, 8}, {1, 0.5}, {1 + 2 * ulp, 0.5})));
  EXPECT_FALSE(move_as_one(disks({8, 8}, {1, 0.5}, {1 + 3 * ulp, 0.5})));
  EXPECT_FALSE(move_as_one(disks({8, 8}, {1, 0}, {1, 0x1p-1000})));
}

TEST(Rest, DisksOnParallelLinesNeverMeetThatAreADiameterApart) {
  EXPECT_TRUE(never_meet(disks({8, 5.001}, {1, 0}, {-1, 0})));
  EXPECT_FALSE(never_meet(disks({8, 4.999}, {1, 0}, {-1, 0})));
  EXPECT_FALSE(never_meet(disks({8, 8}, {1, 0}, {-1, 0.001})));  // one day
}

TEST(Rest, DisksStayApartUntilTheTimeOfTheirContact) {
  // A gap of 3 closes with speed 2.
  const Disks head_on = disks({8, 4}, {1, 0}, {-1, 0});
  EXPECT_EQ(certainly_apart(head_on, 1.0, 0.0), 1);
  const double apart = certainly_apart(head_on, 100.0, 0.0);
  EXPECT_LE(apart, 1.5);
  EXPECT_GT(apart, 1.4);
}

TEST(Rest, ShearedDisksInOneRowOfImagesStayApart) {
  // Both at rest in their layers, 8 apart along y: the layers slide, the distance along y stays.
  EXPECT_TRUE(stay_apart_sheared(disks({4, 12}, {0, 0}, {0, 0}, 1), 100));
  EXPECT_FALSE(stay_apart_sheared(disks({4, 12}, {0, 0}, {0, -1}, 1), 100));
}

TEST(Rest, FastestIsToldRelativeToAVelocity) {
  const Disks pair = disks({8, 8}, {1, 0.5}, {-1, 0.25});
  EXPECT_EQ(fastest_beside(pair, {{0, 0}}), 1);
  EXPECT_EQ(fastest_beside(pair, {{1, 0}}), 2);
}

}  // namespace
}  // namespace zenosphere
