#pragma once

#include <optional>

#include "proof/rational_matrix.hpp"

namespace zenosphere {

/// From, to.
struct Enclosure {
  Rational lower;
  Rational upper;
};

/// A cone of vectors that a matrix maps into itself, proven in exact arithmetic.
///
/// In the coordinates z = B^-1 y of a basis B it is z_0 > 0, |z_i| <= r_i z_0. With M = B^-1 A B
/// every vector of it has |(A z)_i| <= (|M_i0| + sum_k |M_ik| r_k) z_0 and (A z)_0 >= (M_00 - sum_k
/// |M_0k| r_k) z_0, k >= 1; so it is invariant where r_i (M_00 - sum_k |M_0k| r_k) is at least the
/// former for every i. The basis is only a good guess: the inequalities hold exactly, or there is
/// no cone.
class InvariantCone {
 public:
  /// A cone that contains y, or nothing. Any basis of eigenvectors with the largest first will do
  /// if y is near enough to the first.
  static std::optional<InvariantCone> around(const RationalVector& y, const RationalMatrix& matrix);

  /// The coordinate z_0 of a vector, by which all else is measured.
  Rational height(const RationalVector& y) const;
  /// Between which numbers f(y) / z_0 lies for y in the cone.
  Enclosure range(const RationalVector& form) const;
  /// By which factor z_0 changes under the matrix: between these numbers, both positive.
  const Enclosure& growth() const { return growth_; }

 private:
  InvariantCone(RationalMatrix basis, RationalVector height, RationalVector radii)
      : basis_(std::move(basis)), height_(std::move(height)), radii_(std::move(radii)) {}
  bool is_invariant_under(const RationalMatrix& mapped);

  RationalMatrix basis_;
  RationalVector height_;  ///< the first row of its inverse
  RationalVector radii_;   ///< the first one is 1
  Enclosure growth_;
};

/// The product of a row and a matrix: the form f(A y) of y.
RationalVector pulled_back(const RationalVector& form, const RationalMatrix& matrix);

}  // namespace zenosphere
