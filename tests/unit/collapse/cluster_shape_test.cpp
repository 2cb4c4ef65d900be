#include "collapse/cluster_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace zenosphere {
namespace {

/// Connects the pairs of the normals and shapes the cluster of their first sphere.
Cluster shaped(const Normals<2>& normals) {
  ContactGraph graph;
  for (const auto& [pair, normal] : normals) graph.connect(pair.first, pair.second);
  return cluster_of<2>(graph.component(normals.begin()->first.first), graph, normals);
}

TEST(ClusterShape, OfAStraightChainHasStraightnessOneAndNoBends) {
  // 0 - 2 - 1 along x: from 1 to 2 the normal points back.
  const Cluster cluster = shaped({{{0, 2}, {{1, 0}}}, {{1, 2}, {{-1, 0}}}});
  EXPECT_EQ(cluster.chain, (std::vector<std::int32_t>{0, 2, 1}));
  EXPECT_EQ(cluster.straightness, 1);
  EXPECT_EQ(cluster.bends, std::vector<double>{0});
  // From the mean: 0 at -1, 1 at +1, 2 in the middle.
  EXPECT_EQ(cluster.positions, (std::vector<double>{-1, 0, 1, 0, 0, 0}));
}

TEST(ClusterShape, OfARightAngleIsTheRootOfOneHalf) {
  const Cluster cluster = shaped({{{0, 1}, {{1, 0}}}, {{1, 2}, {{0, 1}}}});
  EXPECT_DOUBLE_EQ(cluster.straightness, std::sqrt(2.0) / 2);
  ASSERT_EQ(cluster.bends.size(), 1u);
  EXPECT_NEAR(cluster.bends[0], std::numbers::pi / 2, 1e-15);
}

TEST(ClusterShape, KeepsTheDigitsOfASmallBend) {
  const double bend = 1e-9;  // its cosine is 1 to the last bit
  const Cluster cluster =
      shaped({{{0, 1}, {{1, 0}}}, {{1, 2}, {{std::cos(bend), std::sin(bend)}}}});
  ASSERT_EQ(cluster.bends.size(), 1u);
  EXPECT_NEAR(cluster.bends[0], bend, 1e-24);
}

TEST(ClusterShape, PlacesSpheresInContactOneDiameterApart) {
  const double root = std::sqrt(3.0) / 2;
  const Cluster cluster =
      shaped({{{0, 1}, {{1, 0}}}, {{0, 2}, {{0.5, root}}}, {{1, 2}, {{-0.5, root}}}});
  for (const auto& [a, b] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
    const auto at = [&](int sphere, int axis) {
      return cluster.positions[static_cast<std::size_t>(2 * sphere + axis)];
    };
    EXPECT_NEAR(std::hypot(at(b, 0) - at(a, 0), at(b, 1) - at(a, 1)), 1, 1e-15);
  }
  EXPECT_NEAR(cluster.straightness, 0.5, 1e-15);  // around it, two bonds lead to a neighbour
}

TEST(ClusterShape, OfASphereAloneIsAPoint) {
  ContactGraph graph;
  graph.add(3);
  const Cluster cluster = cluster_of<2>({3}, graph, {});
  EXPECT_EQ(cluster.chain, std::vector<std::int32_t>{3});
  EXPECT_EQ(cluster.straightness, 1);
  EXPECT_EQ(cluster.positions, (std::vector<double>{0, 0}));
}

}  // namespace
}  // namespace zenosphere
