#include "collapse/contact_graph.hpp"

#include <gtest/gtest.h>

namespace zenosphere {
namespace {

using Spheres = std::vector<std::int32_t>;

/// 4-1-7-9-10 with 8 beside 7, and 2-3 apart.
ContactGraph two_clusters() {
  ContactGraph graph;
  graph.connect(1, 4);
  graph.connect(1, 7);
  graph.connect(7, 9);
  graph.connect(7, 8);
  graph.connect(9, 10);
  graph.connect(2, 3);
  return graph;
}

TEST(ContactGraph, ComponentIsWhatContactsConnect) {
  const ContactGraph graph = two_clusters();
  EXPECT_EQ(graph.component(9), (Spheres{1, 4, 7, 8, 9, 10}));
  EXPECT_EQ(graph.component(3), (Spheres{2, 3}));
}

TEST(ContactGraph, LongestWayIsTheBackbone) {
  EXPECT_EQ(two_clusters().longest_way(8), (Spheres{4, 1, 7, 9, 10}));
}

TEST(ContactGraph, LongestWayThroughARingGoesAround) {
  ContactGraph ring;
  for (std::int32_t i = 0; i < 5; ++i) ring.connect(i, (i + 1) % 5);
  EXPECT_EQ(ring.longest_way(3), (Spheres{0, 1, 2, 3, 4}));
}

TEST(ContactGraph, LongestWayThroughARingWithATailIsAShortestOne) {
  ContactGraph graph;
  for (std::int32_t i = 0; i < 4; ++i) graph.connect(i, (i + 1) % 4);
  graph.connect(2, 7);
  EXPECT_EQ(graph.longest_way(0).size(), 4u);  // 0, 1 or 3, 2, 7
}

TEST(ContactGraph, ASphereAloneIsAClusterAndAWay) {
  ContactGraph graph;
  graph.add(5);
  EXPECT_EQ(graph.component(5), Spheres{5});
  EXPECT_EQ(graph.longest_way(5), Spheres{5});
}

TEST(ContactGraph, ConnectingTwiceIsConnectingOnce) {
  ContactGraph graph;
  graph.connect(0, 1);
  graph.connect(1, 0);
  EXPECT_EQ(graph.neighbours(0), Spheres{1});
}

}  // namespace
}  // namespace zenosphere
