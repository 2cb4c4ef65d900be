#include "engine/growth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "engine/close_pairs.hpp"
#include "model/power.hpp"

namespace zenosphere {
namespace {

/// Diameters of N spheres, every second one of the given ratio to the others.
std::vector<double> bidisperse(int spheres, double ratio) {
  std::vector<double> diameters(static_cast<std::size_t>(spheres), 1.0);
  for (std::size_t i = 1; i < diameters.size(); i += 2) diameters[i] = ratio;
  return diameters;
}

template <int Dim>
ShearBox<Dim, double> box_filled_to(double fraction, const std::vector<double>& diameters,
                                    std::optional<int> closed = std::nullopt) {
  double volume = 0;
  for (const double d : diameters) volume += std::numbers::pi / (Dim == 3 ? 6 : 4) * power<Dim>(d);
  Vec<Dim, double> sides;
  for (int axis = 0; axis < Dim; ++axis) sides[axis] = std::pow(volume / fraction, 1.0 / Dim);
  return {sides, 0, 1.5, closed};
}

/// Smallest surface distance of two spheres, by looking at all pairs and images; longer than a side
/// where there is no pair.
template <int Dim>
double closest_gap(const std::vector<Vec<Dim, double>>& places,
                   const std::vector<double>& diameters, const ShearBox<Dim, double>& box) {
  double closest = 2 * box.sides()[0];
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      Vec<Dim, double> apart = places[i] - places[j];
      for (int axis = 0; axis < Dim; ++axis) {
        const double side = box.sides()[axis];
        if (!box.is_closed(axis)) apart[axis] -= side * std::round(apart[axis] / side);
      }
      closest = std::min(closest, std::sqrt(dot(apart, apart)) - (diameters[i] + diameters[j]) / 2);
    }
  }
  return closest;
}

template <int Dim>
void expect_apart(double fraction, const std::vector<double>& diameters) {
  const auto box = box_filled_to<Dim>(fraction, diameters);
  Random random(3);
  const auto places = grown_places<Dim>(diameters, box, random);
  ASSERT_EQ(places.size(), diameters.size());
  for (const auto& place : places) {
    for (int axis = 0; axis < Dim; ++axis) {
      EXPECT_GE(place[axis], 0);
      EXPECT_LT(place[axis], box.sides()[axis]);
    }
  }
  EXPECT_GT((closest_gap<Dim>(places, diameters, box)), 0) << fraction;
}

TEST(Growth, PacksSpheresOfOneKindTo62PerCent) { expect_apart<3>(0.62, bidisperse(200, 1)); }

TEST(Growth, PacksDisksOfOneKindTo80PerCent) { expect_apart<2>(0.80, bidisperse(200, 1)); }

TEST(Growth, PacksMixturesDenser) {
  expect_apart<3>(0.64, bidisperse(200, 1.4));
  expect_apart<2>(0.82, bidisperse(200, 1.4));
}

TEST(Growth, PacksSpheresOfVeryDifferentSizes) {
  std::vector<double> diameters = bidisperse(300, 1);
  diameters[7] = diameters[8] = 5;
  expect_apart<3>(0.6, diameters);
  for (std::size_t i = 0; i < diameters.size(); ++i)
    diameters[i] = 0.5 + 0.01 * static_cast<double>(i);
  expect_apart<3>(0.6, diameters);
  expect_apart<2>(0.8, diameters);
}

TEST(Growth, IsFreeOfOverlapsInTheThinnestGasAndTheSmallestBox) {
  expect_apart<3>(1e-4, bidisperse(10, 1));
  expect_apart<3>(0.3, bidisperse(5, 1));  // side 2.06
  expect_apart<2>(0.4, bidisperse(3, 1.2));
  expect_apart<3>(0.05, {1.0});
}

TEST(Growth, KeepsClearOfWalls) {
  const std::vector<double> diameters = bidisperse(150, 1.4);
  const auto box = box_filled_to<3>(0.5, diameters, 1);
  Random random(5);
  const auto places = grown_places<3>(diameters, box, random);
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_GT(places[i][1], diameters[i] / 2);
    EXPECT_LT(places[i][1], box.sides()[1] - diameters[i] / 2);
  }
  EXPECT_GT((closest_gap<3>(places, diameters, box)), 0);
}

TEST(Growth, SaysWhereItJams) {
  // Random packings of equal spheres end near 0.64, far below the closest one of 0.74.
  const std::vector<double> diameters = bidisperse(200, 1);
  Random random(1);
  try {
    grown_places<3>(diameters, box_filled_to<3>(0.72, diameters), random);
    FAIL() << "0.72 was reached";
  } catch (const Jammed& jammed) {
    EXPECT_GT(jammed.reached(), 0.62);
    EXPECT_LT(jammed.reached(), 0.66);
  }
}

TEST(Growth, EndsBetweenWallsThatASphereAllButTouches) {
  // It bounces ever faster; only bounces that count as collisions end a round.
  const ShearBox<3, double> box({{6, 1 + 1e-3, 6}}, 0, 1.5, 1);
  const std::vector<double> diameters{1};
  Random random(1);
  const auto places = grown_places<3>(diameters, box, random);
  EXPECT_GT(places[0][1], 0.5);
  EXPECT_LT(places[0][1], 0.5 + 1e-3);
}

TEST(Growth, FollowsTheSeed) {
  const std::vector<double> diameters = bidisperse(60, 1.4);
  const auto box = box_filled_to<3>(0.55, diameters);
  Random one(1);
  Random same(1);
  Random other(2);
  const auto places = grown_places<3>(diameters, box, one);
  EXPECT_EQ(places, grown_places<3>(diameters, box, same));
  EXPECT_NE(places, grown_places<3>(diameters, box, other));
}

TEST(Growth, PutsRodsOfDifferentLengthsInRandomOrder) {
  const std::vector<double> lengths = bidisperse(40, 3);
  const ShearBox<1, double> box(Vec<1, double>{{100}}, 0);  // 80 of 100 are filled
  Random random(1);
  const auto places = grown_places<1>(lengths, box, random);
  std::vector<std::size_t> order(lengths.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return places[a][0] < places[b][0]; });
  int equal_ones = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool is_last = k + 1 == order.size();
    const double next = is_last ? places[order[0]][0] + 100 : places[order[k + 1]][0];
    const std::size_t follower = order[is_last ? 0 : k + 1];
    EXPECT_GE(next - places[order[k]][0], (lengths[order[k]] + lengths[follower]) / 2 - 1e-13);
    if (lengths[order[k]] == lengths[follower]) ++equal_ones;
  }
  EXPECT_GT(equal_ones, 5);  // of 40, 20 in the mean; none if they still alternated
}

TEST(ClosePairs, AreThoseThatALookAtAllPairsFinds) {
  std::vector<double> diameters;
  std::vector<Vec<3, double>> places;
  Random random(4);
  const ShearBox<3, double> box({{9, 7, 5}}, 0, 1.5, 2);
  for (int i = 0; i < 100; ++i) {
    diameters.push_back(i % 7 == 0 ? 2.0 : 0.1 + 0.4 * random.uniform());
    places.push_back({{9 * random.uniform(), 7 * random.uniform(), 5 * random.uniform()}});
  }
  const double margin = 0.3;
  std::vector<std::pair<std::int32_t, std::int32_t>> found;
  for (const auto& pair : close_pairs<3>(places, diameters, box, margin)) {
    found.push_back(std::minmax(pair.i, pair.j));
  }
  std::vector<std::pair<std::int32_t, std::int32_t>> expected;
  for (std::int32_t i = 0; i < 100; ++i) {
    for (std::int32_t j = i + 1; j < 100; ++j) {
      const std::vector<Vec<3, double>> two{places[static_cast<std::size_t>(i)],
                                            places[static_cast<std::size_t>(j)]};
      const std::vector<double> both{diameters[static_cast<std::size_t>(i)],
                                     diameters[static_cast<std::size_t>(j)]};
      if (closest_gap<3>(two, both, box) < margin) expected.emplace_back(i, j);
    }
  }
  std::sort(found.begin(), found.end());
  EXPECT_GT(expected.size(), 50u);
  EXPECT_EQ(found, expected);
}

TEST(ClosePairs, SeeBothImagesInASmallBox) {
  // On a ring of 2.2, places 0.05 and 1.15 are 1.1 apart on either side.
  const ShearBox<3, double> box({{2.2, 9, 9}}, 0);
  const std::vector<Vec<3, double>> places{{{0.05, 4, 4}}, {{1.15, 4, 4}}};
  const std::vector<double> diameters{1, 1};
  EXPECT_EQ(close_pairs<3>(places, diameters, box, 0.2).size(), 2u);
  EXPECT_EQ(close_pairs<3>(places, diameters, box, 0.05).size(), 0u);
}

}  // namespace
}  // namespace zenosphere
