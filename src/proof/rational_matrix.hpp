#pragma once

#include <optional>
#include <vector>

#include "proof/rational.hpp"

namespace zenosphere {

using RationalVector = std::vector<Rational>;
/// Rows of equal length.
using RationalMatrix = std::vector<RationalVector>;

RationalMatrix identity_matrix(std::size_t size);
RationalMatrix product(const RationalMatrix& a, const RationalMatrix& b);
RationalVector product(const RationalMatrix& a, const RationalVector& x);
/// a^exponent by squaring; exponent >= 0.
RationalMatrix power(RationalMatrix a, long exponent);
/// Nothing where the matrix is singular.
std::optional<RationalMatrix> inverse(RationalMatrix a);

/// The map that a induces on the minors x_i y_j - x_j y_i of two vectors, i < j, in the order
/// (0,1), (0,2), ..., (1,2), ...: the exterior square of a.
RationalMatrix exterior_square(const RationalMatrix& a);
/// These minors of two vectors of the same length.
RationalVector minors(const RationalVector& x, const RationalVector& y);
/// Where the minor (i, j), i < j, stands among those of vectors of `size` numbers.
std::size_t minor_index(std::size_t i, std::size_t j, std::size_t size);

}  // namespace zenosphere
