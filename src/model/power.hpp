#pragma once

namespace zenosphere {

/// length^Dim, from products only.
template <int Dim>
constexpr double power(double length) {
  double product = length;
  for (int axis = 1; axis < Dim; ++axis) product *= length;
  return product;
}

}  // namespace zenosphere
