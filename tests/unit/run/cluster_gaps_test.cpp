#include "run/cluster_gaps.hpp"

#include <gtest/gtest.h>

#include <array>

namespace zenosphere {
namespace {

using Place = Vec<2, double>;

Simulation<2, double> discs(std::vector<Place> places, std::vector<Place> velocities,
                            double shear_rate = 0) {
  const Configuration<2, double> start{std::move(places), std::move(velocities)};
  return {ShearBox<2, double>(Place{20, 20}, shear_rate), start, {0.5}};
}

constexpr std::array<std::int32_t, 3> all{0, 1, 2};

TEST(ClusterGaps, SmallestGapIsThatOfTheClosestTwoThatApproach) {
  const auto gas = discs({{1, 5}, {2.001, 5}, {4, 5}}, {{1, 0}, {0, 0}, {0, 0}});
  EXPECT_NEAR(ClusterGaps(gas).smallest(all, 16), 3, 1e-9);
}

TEST(ClusterGaps, OnePairThatRecedesIsPassedOver) {
  // The first two have just met; the third is 0.01 from the second.
  const auto gas = discs({{1, 5}, {2, 5}, {3.01, 5}}, {{-1, 0}, {0, 0}, {0, 0}});
  EXPECT_NEAR(ClusterGaps(gas).smallest(all, 16), 2, 1e-9);
}

TEST(ClusterGaps, SecondPairThatRecedesCounts) {
  const auto gas = discs({{1, 5}, {2, 5}, {3.000001, 5}}, {{-1, 0}, {0, 0}, {1, 0}});
  EXPECT_NEAR(ClusterGaps(gas).smallest(all, 16), 6, 1e-6);
}

TEST(ClusterGaps, SpheresThatOverlapAreAtTheLimit) {
  const auto gas = discs({{1, 5}, {1.99999, 5}, {4, 5}}, {{1, 0}, {0, 0}, {0, 0}});
  EXPECT_EQ(ClusterGaps(gas).smallest(all, 16), 16);
}

// At rate 1 the image of the box above moves at a speed of 20 along x. The image of disc 0 above
// disc 1 is at (4.99, 20.05), 1.1 away along y and 0.01 behind, and overtakes: it approaches by
// that. Their peculiar velocities are 0, so with those alone no sphere would.
TEST(ClusterGaps, PairAcrossTheGradientFaceSeesTheVelocityOfTheImage) {
  const auto gas = discs({{4.99, 0.05}, {5, 18.95}, {12, 10}}, {{0, 0}, {0, 0}, {0, 0}}, 1);
  EXPECT_NEAR(ClusterGaps(gas).smallest(all, 16), 1, 0.01);  // hypot(1.1, 0.01) - 1 = 0.10005
}

// The upper images are displaced by 3: that of disc 0, at (5, 20.05), is 1.1 above disc 1.
TEST(ClusterGaps, PairAcrossTheGradientFaceSeesTheImageWhereItIsDisplacedTo) {
  Configuration<2, double> start{{{2, 0.05}, {5, 18.95}, {12, 10}}, {{0, -1}, {0, 0}, {0, 0}}};
  start.offset = 3;
  const Simulation<2, double> gas(ShearBox<2, double>(Place{20, 20}, 0), start, {0.5});
  EXPECT_NEAR(ClusterGaps(gas).smallest(all, 16), 1, 1e-9);
}

}  // namespace
}  // namespace zenosphere
