#include "io/start_overlap.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace zenosphere {
namespace {

TEST(FirstOverlap, AgreesWithLookingAtEveryPair) {
  // 60 spheres at multiples of an irrational number, in boxes of one, two and many cells a side.
  for (const std::vector<double>& sides :
       {std::vector<double>{2.5, 30, 1.2}, {3.5, 4, 9}, {60, 7}, {150}}) {
    std::vector<double> positions;
    for (std::size_t n = 1; n <= 60 * sides.size(); ++n) {
      const double part = std::fmod(static_cast<double>(n * n) * 0.6180339887498949, 1.0);
      positions.push_back(part * sides[(n - 1) % sides.size()]);
    }
    const int closed = static_cast<int>(sides.size()) - 1;
    std::string expected;
    for (std::size_t i = 0; i < 60 && expected.empty(); ++i) {
      for (std::size_t j = i + 1; j < 60 && expected.empty(); ++j) {
        double square = 0;
        for (std::size_t axis = 0; axis < sides.size(); ++axis) {
          double along =
              std::abs(positions[i * sides.size() + axis] - positions[j * sides.size() + axis]);
          if (static_cast<int>(axis) != closed) along = std::min(along, sides[axis] - along);
          square += along * along;
        }
        if (square < 1) expected = fmt::format("{} {}", i, j);
      }
    }
    const auto found = first_overlap(positions, sides, closed);
    ASSERT_TRUE(found) << sides.size();
    EXPECT_EQ(fmt::format("{} {}", found->i, found->j), expected) << sides.size();
  }
}

TEST(FirstOverlap, ManyTouchingSpheresPassAndOneDisplacedAmongThemIsFound) {
  // A simple cubic lattice of 20^3 touching spheres; number 4210 is at (10, 10, 10).
  std::vector<double> positions;
  for (int n = 0; n < 8000; ++n) {
    for (const int component : {n / 400, n / 20 % 20, n % 20}) positions.push_back(component);
  }
  EXPECT_FALSE(first_overlap(positions, {20, 20, 20}, std::nullopt));
  positions[3 * 4210] += 0.25;
  const auto found = first_overlap(positions, {20, 20, 20}, std::nullopt);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->i, 4210);
  EXPECT_EQ(found->j, 4610);  // the neighbour at (11, 10, 10)
  EXPECT_EQ(found->distance, 0.75);
}

}  // namespace
}  // namespace zenosphere
