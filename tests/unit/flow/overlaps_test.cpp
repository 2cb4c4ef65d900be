#include "flow/overlaps.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zenosphere {
namespace {

TEST(DeepestOverlap, IsNoneOfSpheresApart) {
  EXPECT_LE(deepest_overlap({{1, 1, 3, 1}, {10, 8}}).depth, 0);
}

TEST(DeepestOverlap, NamesThePairAndItsDepth) {
  const Overlap overlap = deepest_overlap({{1, 1, 3, 1, 3.75, 1, 3, 1.875}, {10, 8}});
  EXPECT_EQ(overlap.i, 1);
  EXPECT_EQ(overlap.j, 2);
  EXPECT_EQ(overlap.depth, 0.25);
}

TEST(DeepestOverlap, SeesThroughPeriodicFacesAndNotThroughWalls) {
  const PlacedSpheres across{{0.25, 4, 9.75, 4}, {10, 8}};
  EXPECT_EQ(deepest_overlap(across).depth, 0.5);
  PlacedSpheres walled = across;
  walled.closed = 0;
  EXPECT_LE(deepest_overlap(walled).depth, 0);
}

TEST(DeepestOverlap, FindsTheImageThatShearHasDisplaced) {
  // The upper image of the box is shifted by 3: what is at x = 1 below is at x = 4 above.
  const std::vector<double> positions{1, 0.25, 4, 7.75};
  EXPECT_EQ(deepest_overlap({positions, {10, 8}, 3}).depth, 0.5);
  EXPECT_LE(deepest_overlap({positions, {10, 8}, 0}).depth, 0);
  EXPECT_LE(deepest_overlap({positions, {10, 8}, -3}).depth, 0);
}

TEST(DeepestOverlap, OfSpheresOfManySizesIsThatOfEveryPair) {
  // Diameters from 0.02 to 2, so that there are seven classes; at each step one pair more.
  std::vector<double> positions;
  std::vector<double> diameters;
  double deepest = -1;
  for (std::size_t n = 0; n < 300; ++n) {
    const auto part = [&](double number) {
      return std::fmod(static_cast<double>((n + 1) * (n + 1)) * number, 1.0);
    };
    positions.push_back(30 * part(0.6180339887498949));
    positions.push_back(20 * part(0.4142135623730951));
    diameters.push_back(0.02 * std::pow(100.0, part(0.7320508075688772)));
    for (std::size_t i = 0; i < n; ++i) {
      double x = positions[2 * n] - positions[2 * i];
      double y = positions[2 * n + 1] - positions[2 * i + 1];
      x -= 30 * std::round(x / 30);
      y -= 20 * std::round(y / 20);
      const double sigma = (diameters[i] + diameters[n]) / 2;
      deepest = std::max(deepest, sigma - std::sqrt(x * x + y * y));
    }
    const Overlap found = deepest_overlap({positions, {30, 20}, 0, {}, diameters});
    if (deepest > 0) {
      ASSERT_NEAR(found.depth, deepest, 1e-14) << n;
    } else {
      ASSERT_LE(found.depth, 0) << n;
    }
    ASSERT_LE(found.i, found.j);
  }
  EXPECT_GT(deepest, 0);
}

TEST(DeepestOverlap, AgreesWithLookingAtEveryPair) {
  // Places at multiples of an irrational number, in boxes of two, three and many cells a side.
  for (const std::vector<double>& sides :
       {std::vector<double>{2.5, 3.4, 30}, {30, 2.2, 3}, {12, 11}, {40}}) {
    PlacedSpheres spheres{{}, sides, sides.size() > 1 ? 0.7 : 0.0};
    for (std::size_t n = 1; n <= 40 * sides.size(); ++n) {
      const double part = std::fmod(static_cast<double>(n * n) * 0.6180339887498949, 1.0);
      spheres.positions.push_back(part * sides[(n - 1) % sides.size()]);
    }
    double deepest = -1;
    for (std::size_t i = 0; i < 40; ++i) {
      for (std::size_t j = i + 1; j < 40; ++j) {
        double square = 0;
        double shift = 0;
        for (std::size_t axis = sides.size(); axis-- > 0;) {
          double along = spheres.positions[j * sides.size() + axis] -
                         spheres.positions[i * sides.size() + axis] - (axis == 0 ? shift : 0);
          const double boxes = std::round(along / sides[axis]);
          if (axis == 1) shift = boxes * spheres.offset;
          along -= boxes * sides[axis];
          square += along * along;
        }
        deepest = std::max(deepest, 1 - std::sqrt(square));
      }
    }
    ASSERT_GT(deepest, 0.1);
    EXPECT_EQ(deepest_overlap(spheres).depth, deepest) << sides.size();
  }
}

TEST(DeepestPermitted, IsRoundingButForTheRuleThatLetsSpheresPass) {
  EXPECT_EQ(deepest_permitted(OverlapRule::immediate, 1e-15, 1e9, 32), 1e-9);
  // In a box of 2^29 diameters 256 units in the last place of a side: 2^8 x 2^-52 x 2^29.
  EXPECT_EQ(deepest_permitted(OverlapRule::immediate, 1e-15, 1e9, 0x1p29), 0x1p-15);
  EXPECT_EQ(deepest_permitted(OverlapRule::guarded, 1e-15, 1e9, 32), 1e-9 + 1e-15 * 1e9);
}

TEST(DeepestPermitted, IsTwoOfTheLongestWaysBackWithRewind) {
  // A side of 32: delta = 4 x 2^-52 x 2^5 = 2^-45, and 32 sqrt(2 delta) = 2^5 x 2^-22 = 2^-17.
  EXPECT_EQ(deepest_permitted(OverlapRule::rewind, 1e-15, 1e9, 32), 1e-9 + 2 * 0x1p-17);
}

}  // namespace
}  // namespace zenosphere
