#pragma once

#include <numbers>

namespace zenosphere {

/// length^Dim, from products only.
template <int Dim>
constexpr double power(double length) {
  double product = length;
  for (int axis = 1; axis < Dim; ++axis) product *= length;
  return product;
}

/// Volume of a sphere of diameter 1 in one, two or three dimensions.
constexpr double unit_sphere_volume(int dimension) {
  return dimension == 1 ? 1.0 : std::numbers::pi / (dimension == 2 ? 4 : 6);
}

}  // namespace zenosphere
