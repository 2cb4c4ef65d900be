#include "engine/simd/places_in_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>

#include "engine/simd/wide_lanes.hpp"
#include "support/gas.hpp"

namespace zenosphere {
namespace {

using Numbers = std::array<double, most_in_order>;

Numbers some_numbers(support::Dice& dice, std::size_t count) {
  Numbers numbers;
  numbers.fill(std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < count; ++k) numbers[k] = dice.between(-1, 1);
  return numbers;
}

TEST(PlacesInOrder, AreThoseThatASortFinds) {
  if (!has_wide_lanes()) GTEST_SKIP() << "no AVX2 here";
  support::Dice dice(7);
  for (int n = 0; n < 10000; ++n) {
    const auto count = static_cast<std::size_t>(dice.below(16));
    const Numbers numbers = some_numbers(dice, count);
    const PlacesInOrder order = places_in_order_wide(numbers, count);
    ASSERT_TRUE(order.all_differ);
    Numbers sorted = numbers;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t k = 0; k < count; ++k) {
      ASSERT_EQ(sorted[static_cast<std::size_t>(order.places[k])], numbers[k]);
    }
    ASSERT_GE(order.compared, count);
    for (std::size_t k = count; k < order.compared; ++k) {
      ASSERT_EQ(static_cast<std::size_t>(order.places[k]), count);
    }
  }
}

TEST(PlacesInOrder, TellWhetherTwoNumbersAreEqual) {
  if (!has_wide_lanes()) GTEST_SKIP() << "no AVX2 here";
  support::Dice dice(8);
  for (int n = 0; n < 1000; ++n) {
    const auto count = static_cast<std::size_t>(2 + dice.below(14));
    Numbers numbers = some_numbers(dice, count);
    const auto twin = static_cast<std::size_t>(dice.below(static_cast<int>(count) - 1));
    numbers[count - 1] = numbers[twin];
    ASSERT_FALSE(places_in_order_wide(numbers, count).all_differ);
  }
  EXPECT_FALSE(places_in_order_wide(Numbers{0.0, -0.0}, most_in_order).all_differ);
}

}  // namespace
}  // namespace zenosphere
