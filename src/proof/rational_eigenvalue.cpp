#include "proof/rational_eigenvalue.hpp"

namespace zenosphere {

namespace {

/// l with l (a - value) = 0 and l_0 = 1, or nothing.
std::optional<RationalVector> left_eigenvector(const RationalMatrix& a, const Rational& value) {
  const std::size_t size = a.size();
  // sum_i l_i a_ij = value l_j. The unknowns l_1, l_2, ... follow from the columns j >= 1.
  RationalMatrix rest(size - 1, RationalVector(size - 1));
  RationalVector right(size - 1);
  for (std::size_t j = 1; j < size; ++j) {
    for (std::size_t i = 1; i < size; ++i) rest[j - 1][i - 1] = a[i][j];
    rest[j - 1][j - 1] -= value;
    right[j - 1] = -a[0][j];
  }
  const auto inverted = inverse(rest);
  if (!inverted) return std::nullopt;
  RationalVector left = product(*inverted, right);
  left.insert(left.begin(), 1);
  if (pulled_back(left, a)[0] != value) return std::nullopt;
  return left;
}

}  // namespace

Rational simplest_between(const Enclosure& interval) {
  Integer floor;
  mpz_fdiv_q(floor.get_mpz_t(), interval.lower.get_num_mpz_t(), interval.lower.get_den_mpz_t());
  if (interval.lower == floor) return floor;
  if (interval.upper >= floor + 1) return Rational(floor + 1);
  return floor + 1 / simplest_between({1 / (interval.upper - floor), 1 / (interval.lower - floor)});
}

std::optional<Rational> rational_collapse_time(const RationalMatrix& round,
                                               const Enclosure& largest, const RowState& state) {
  const auto left = left_eigenvector(round, simplest_between(largest));
  if (!left) return std::nullopt;
  Rational c;
  Rational u;
  for (std::size_t i = 0; i < left->size(); ++i) {
    c += (*left)[i] * state.c[i];
    u += (*left)[i] * state.u[i];
  }
  if (u == 0) return std::nullopt;
  return -c / u;
}

}  // namespace zenosphere
