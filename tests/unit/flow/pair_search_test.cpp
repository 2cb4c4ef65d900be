#include "flow/pair_search.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <utility>

namespace zenosphere {
namespace {

template <int Dim>
struct Place {
  SampledSystem<Dim> system;
  SampledMoment<Dim> moment;
};

template <int Dim>
Place<Dim> random_place(const Vec<Dim, double>& sides, std::int32_t spheres, double offset,
                        std::optional<int> closed, unsigned seed) {
  std::mt19937_64 random(seed);
  Place<Dim> place{{spheres, sides, closed, 0, {}}, {{}, {}, offset}};
  for (std::int32_t i = 0; i < spheres; ++i) {
    Vec<Dim, double> position;
    for (int axis = 0; axis < Dim; ++axis) {
      position[axis] = std::uniform_real_distribution<double>(0, sides[axis])(random);
    }
    place.moment.positions.push_back(position);
  }
  return place;
}

using Pairs = std::map<std::pair<std::int32_t, std::int32_t>, double>;

/// Each pair in every image: within the reach there is one at most.
template <int Dim>
Pairs by_brute_force(const Place<Dim>& place, double reach) {
  Pairs pairs;
  const auto& [system, moment] = place;
  for (std::int32_t i = 0; i < system.spheres; ++i) {
    for (std::int32_t j = i + 1; j < system.spheres; ++j) {
      const auto apart = moment.positions[static_cast<std::size_t>(j)] -
                         moment.positions[static_cast<std::size_t>(i)];
      for (int image = 0; image < 125; ++image) {  // -2 to 2 along each axis
        int left = image;
        Vec<Dim, double> dr = apart;
        bool exists = true;
        for (int axis = 0; axis < 3; ++axis, left /= 5) {
          const int steps = left % 5 - 2;
          if (axis >= Dim) {
            exists = exists && steps == 0;
            continue;
          }
          exists = exists && (steps == 0 || system.closed_axis != axis);
          dr[axis] += steps * system.sides[axis];
          if (axis == 1) dr[0] += steps * moment.offset;
        }
        if (exists && dot(dr, dr) <= reach * reach) pairs[{i, j}] = dot(dr, dr);
      }
    }
  }
  return pairs;
}

template <int Dim>
void expect_all_pairs(const Place<Dim>& place, double reach) {
  Pairs found;
  PairSearch<Dim>(place.system, place.moment, reach)
      .visit([&](std::int32_t i, std::int32_t j, const auto& dr, double r2) {
        EXPECT_EQ(dot(dr, dr), r2);
        EXPECT_TRUE(found.emplace(std::minmax(i, j), r2).second) << i << ' ' << j << " twice";
      });
  const Pairs expected = by_brute_force(place, reach);
  EXPECT_EQ(found.size(), expected.size());
  for (const auto& [pair, r2] : expected) {
    const auto hit = found.find(pair);
    ASSERT_NE(hit, found.end()) << pair.first << ' ' << pair.second;
    EXPECT_NEAR(hit->second, r2, 1e-12 * reach * reach);  // some ulps of the sides
  }
}

TEST(PairSearch, FindsEachPairOnceThroughSlidingFaces) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    for (const double offset : {0.0, 2.9, -3.0, 0.7}) {
      expect_all_pairs(random_place<3>({{6, 7, 8}}, 60, offset, {}, seed), 3.0);
      expect_all_pairs(random_place<2>({{6, 9}}, 40, offset, {}, seed), 2.0);
    }
  }
}

TEST(PairSearch, FindsEachPairOnceInALongBox) {
  expect_all_pairs(random_place<3>({{30, 5, 6}}, 150, 11.3, {}, 1), 1.7);
  expect_all_pairs(random_place<3>({{5, 30, 6}}, 150, -1.3, {}, 2), 2.5);
  expect_all_pairs(random_place<1>({{50}}, 40, 0, {}, 3), 4.0);
}

TEST(PairSearch, FindsNoPairThroughAWall) {
  for (const int axis : {0, 1, 2}) {
    expect_all_pairs(random_place<3>({{6, 6, 6}}, 60, 0, axis, 4), 3.0);
  }
  expect_all_pairs(random_place<1>({{12}}, 8, 0, 0, 5), 12.0);
}

}  // namespace
}  // namespace zenosphere
