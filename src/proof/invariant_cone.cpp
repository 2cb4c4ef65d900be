#include "proof/invariant_cone.hpp"

#include <algorithm>
#include <utility>

#include "proof/eigenbasis.hpp"

namespace zenosphere {

namespace {

Rational dot(const RationalVector& a, const RationalVector& b) {
  Rational sum;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

/// sum_k |row_k| r_k over all k but the first.
Rational spread(const RationalVector& row, const RationalVector& radii) {
  Rational sum;
  for (std::size_t k = 1; k < row.size(); ++k) sum += abs(row[k]) * radii[k];
  return sum;
}

/// A binary number of 64 bits between value and value (1 + 2^-10): what has thousands of digits is
/// rounded outwards, so that the numbers of the proof stay short.
Rational slightly_above(const Rational& value) {
  if (value == 0) return 0;
  constexpr long root_bits = 64;
  const auto size = [](const Integer& z) {
    return static_cast<long>(mpz_sizeinbase(z.get_mpz_t(), 2));
  };
  const long shift = root_bits - size(value.get_num()) + size(value.get_den());
  const auto bits = static_cast<mp_bitcnt_t>(std::labs(shift));
  Integer top = value.get_num();
  Integer bottom = value.get_den();
  if (shift > 0) {
    top <<= bits;
  } else {
    bottom <<= bits;
  }
  Integer quotient;
  mpz_cdiv_q(quotient.get_mpz_t(), top.get_mpz_t(), bottom.get_mpz_t());
  quotient += quotient >> 11;
  Rational result(quotient);
  if (shift > 0) {
    mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), bits);
  } else {
    mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(), bits);
  }
  return result;
}

/// |z_i| / z_0, slightly enlarged, and not below what the approximation of the basis leaves. Two
/// neighbours that the matrix turns into each other get the same.
RationalVector radii_around(const RationalVector& z, const RationalMatrix& mapped) {
  Rational least(1);
  mpq_div_2exp(least.get_mpq_t(), least.get_mpq_t(), 128);
  RationalVector radii{1};
  for (std::size_t i = 1; i < z.size(); ++i) {
    radii.push_back(std::max(least, slightly_above(abs(z[i]) / z[0])));
  }
  for (std::size_t i = 1; i + 1 < z.size(); ++i) {
    const bool do_turn = abs(mapped[i][i + 1]) > least && abs(mapped[i + 1][i]) > least;
    if (do_turn) radii[i] = radii[i + 1] = std::max(radii[i], radii[i + 1]);
  }
  return radii;
}

}  // namespace

std::optional<InvariantCone> InvariantCone::around(const RationalVector& y,
                                                   const RationalMatrix& matrix) {
  std::optional<RationalMatrix> basis = eigenbasis(matrix);
  if (!basis) return std::nullopt;
  std::optional<RationalMatrix> to_basis = inverse(*basis);
  if (!to_basis) return std::nullopt;
  RationalVector z = product(*to_basis, y);
  if (z[0] == 0) return std::nullopt;
  if (z[0] < 0) {  // the other direction of the eigenvector
    for (RationalVector& row : *basis) row[0] = -row[0];
    for (Rational& value : to_basis->front()) value = -value;
    z[0] = -z[0];
  }
  const RationalMatrix mapped = product(product(*to_basis, matrix), *basis);
  InvariantCone cone(std::move(*basis), to_basis->front(), radii_around(z, mapped));
  if (!cone.is_invariant_under(mapped)) return std::nullopt;
  return cone;
}

bool InvariantCone::is_invariant_under(const RationalMatrix& mapped) {
  const Rational width = spread(mapped[0], radii_);
  growth_ = {mapped[0][0] - width, mapped[0][0] + width};
  if (growth_.lower <= 0) return false;
  for (std::size_t i = 1; i < radii_.size(); ++i) {
    const Rational reach = abs(mapped[i][0]) + spread(mapped[i], radii_);
    if (reach > radii_[i] * growth_.lower) return false;
  }
  return true;
}

Rational InvariantCone::height(const RationalVector& y) const { return dot(height_, y); }

Enclosure InvariantCone::range(const RationalVector& form) const {
  const RationalVector values = pulled_back(form, basis_);
  const Rational width = spread(values, radii_);
  return {values[0] - width, values[0] + width};
}

RationalVector pulled_back(const RationalVector& form, const RationalMatrix& matrix) {
  RationalVector result(matrix.front().size());
  for (std::size_t i = 0; i < form.size(); ++i) {
    if (form[i] == 0) continue;
    for (std::size_t k = 0; k < result.size(); ++k) result[k] += form[i] * matrix[i][k];
  }
  return result;
}

}  // namespace zenosphere
