#include "engine/simd/next_face.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <type_traits>

#include "engine/simd/wide_lanes.hpp"
#include "support/bits.hpp"
#include "support/gas.hpp"

namespace zenosphere {
namespace {

constexpr CellWidths<double> widths{1.5, 1.25, 2};

template <class Dimension>
class NextFaceOfASphere : public ::testing::Test {
 protected:
  static constexpr int Dim = Dimension::value;

  /// A sphere in a cell, or a little outside, as rounding can put it; on some axes it rests, or is
  /// about to, or is on a face, or nowhere.
  Sphere<Dim, double> some_sphere(const Steps<Dim>& cell) {
    constexpr double tiny = std::numeric_limits<double>::denorm_min();
    Sphere<Dim, double> sphere{};
    sphere.time = dice.between(0, 1);
    for (int axis = 0; axis < Dim; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
      const double places[] = {0, 1, -1e-15, dice.between(0, 1), dice.between(0, 1), nowhere};
      const double speeds[] = {0, -0.0, tiny, -tiny, 1, -1, dice.between(-2, 2)};
      sphere.position[axis] = (cell[a] + places[dice.below(6)]) * widths[a];
      sphere.velocity[axis] = speeds[dice.below(7)];
    }
    return sphere;
  }

  support::Dice dice{11};
};

using Dimensions = ::testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                                    std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(NextFaceOfASphere, Dimensions);

TYPED_TEST(NextFaceOfASphere, IsTheSameForAllAxesAtOnceBitForBit) {
  if (!has_wide_lanes()) GTEST_SKIP() << "no AVX2 here";
  constexpr int dim = TypeParam::value;
  int stay = 0;
  for (int n = 0; n < 20000; ++n) {
    Steps<dim> cell;
    for (int& coordinate : cell) coordinate = this->dice.below(50);
    const auto sphere = this->some_sphere(cell);
    const double when = sphere.time + this->dice.below(2) * 0.1;
    const auto expected = next_face<dim>(sphere, cell, widths, when);
    const auto found = next_face_wide<dim>(sphere, cell, widths, when);
    ASSERT_TRUE(support::are_same(found.time, expected.time));
    ASSERT_EQ(found.axis, expected.axis);
    ASSERT_EQ(found.direction, expected.direction);
    stay += expected.direction == 0 ? 1 : 0;
  }
  EXPECT_GT(stay, 100);
}

TYPED_TEST(NextFaceOfASphere, IsTheFirstOnItsWay) {
  constexpr int dim = TypeParam::value;
  Steps<dim> cell;
  cell.fill(3);
  Sphere<dim, double> sphere{};
  sphere.time = 0.25;
  for (int axis = 0; axis < dim; ++axis) {
    sphere.position[axis] = 3 * widths[static_cast<std::size_t>(axis)] + 0.5;
    sphere.velocity[axis] = axis == dim - 1 ? -2 : 0.125;  // 0.25 to go at 2, or 6 and more
  }
  const auto next = next_face<dim>(sphere, cell, widths, 0.25);
  EXPECT_DOUBLE_EQ(next.time, 0.25);
  EXPECT_EQ(next.axis, dim - 1);
  EXPECT_EQ(next.direction, -1);
  EXPECT_DOUBLE_EQ(next_face<dim>(sphere, cell, widths, 0.375).time, 0.125);
  EXPECT_EQ(next_face<dim>(sphere, cell, widths, 1.25).time, 0);  // it is late: at once
  sphere.velocity = {};
  EXPECT_EQ(next_face<dim>(sphere, cell, widths, 0.25).direction, 0);
}

}  // namespace
}  // namespace zenosphere
