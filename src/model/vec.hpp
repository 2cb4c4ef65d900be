#pragma once

#include <array>
#include <cstddef>

namespace zenosphere {

/// A point or a vector in `Dim` dimensions.
template <int Dim, class Real>
struct Vec {
  std::array<Real, Dim> components{};

  constexpr Real& operator[](int axis) { return components[static_cast<std::size_t>(axis)]; }
  constexpr const Real& operator[](int axis) const {
    return components[static_cast<std::size_t>(axis)];
  }

  constexpr Vec& operator+=(const Vec& other) {
    for (int axis = 0; axis < Dim; ++axis) (*this)[axis] += other[axis];
    return *this;
  }
  constexpr Vec& operator-=(const Vec& other) {
    for (int axis = 0; axis < Dim; ++axis) (*this)[axis] -= other[axis];
    return *this;
  }
  constexpr Vec& operator*=(const Real& factor) {
    for (int axis = 0; axis < Dim; ++axis) (*this)[axis] *= factor;
    return *this;
  }

  friend constexpr Vec operator+(Vec a, const Vec& b) { return a += b; }
  friend constexpr Vec operator-(Vec a, const Vec& b) { return a -= b; }
  friend constexpr Vec operator*(Vec a, const Real& factor) { return a *= factor; }
  friend constexpr bool operator==(const Vec&, const Vec&) = default;

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.components);
  }
};

/// Scalar product, summed from the first component to the last.
template <int Dim, class Real>
constexpr Real dot(const Vec<Dim, Real>& a, const Vec<Dim, Real>& b) {
  Real sum = a[0] * b[0];
  for (int axis = 1; axis < Dim; ++axis) sum += a[axis] * b[axis];
  return sum;
}

}  // namespace zenosphere
