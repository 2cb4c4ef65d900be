#pragma once

#include <optional>

#include "proof/rational_matrix.hpp"

namespace zenosphere {

/// A basis in which a matrix is nearly diagonal, its columns ordered by the eigenvalues' moduli,
/// the largest first. Of a pair of conjugate eigenvectors the two columns are real and imaginary
/// part.
///
/// These are approximations, to 256 bits, written as exact numbers: a guess that a proof then
/// verifies. Nothing where they cannot be found, or where the largest eigenvalue is not real and
/// positive, or not alone.
std::optional<RationalMatrix> eigenbasis(const RationalMatrix& matrix);

}  // namespace zenosphere
