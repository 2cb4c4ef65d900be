#include "proof/rational_matrix.hpp"

#include <utility>

namespace zenosphere {

namespace {

/// Takes `factor` times the row `from` away from the row `to`.
void reduce(RationalVector& to, const RationalVector& from, const Rational& factor) {
  if (factor == 0) return;
  for (std::size_t k = 0; k < to.size(); ++k) to[k] -= factor * from[k];
}

}  // namespace

RationalMatrix identity_matrix(std::size_t size) {
  RationalMatrix matrix(size, RationalVector(size));
  for (std::size_t i = 0; i < size; ++i) matrix[i][i] = 1;
  return matrix;
}

RationalVector product(const RationalMatrix& a, const RationalVector& x) {
  RationalVector result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < x.size(); ++k) result[i] += a[i][k] * x[k];
  }
  return result;
}

RationalMatrix product(const RationalMatrix& a, const RationalMatrix& b) {
  RationalMatrix result(a.size(), RationalVector(b.front().size()));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) {
      if (a[i][k] == 0) continue;
      for (std::size_t j = 0; j < result[i].size(); ++j) result[i][j] += a[i][k] * b[k][j];
    }
  }
  return result;
}

RationalMatrix power(RationalMatrix a, long exponent) {
  RationalMatrix result = identity_matrix(a.size());
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) result = product(result, a);
    if (exponent > 1) a = product(a, a);
  }
  return result;
}

std::optional<RationalMatrix> inverse(RationalMatrix a) {
  RationalMatrix result = identity_matrix(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t pivot = i;
    while (pivot < a.size() && a[pivot][i] == 0) ++pivot;
    if (pivot == a.size()) return std::nullopt;
    std::swap(a[i], a[pivot]);
    std::swap(result[i], result[pivot]);
    const Rational scale = 1 / a[i][i];
    for (Rational& value : a[i]) value *= scale;
    for (Rational& value : result[i]) value *= scale;
    for (std::size_t row = 0; row < a.size(); ++row) {
      if (row == i) continue;
      const Rational factor = a[row][i];
      reduce(a[row], a[i], factor);
      reduce(result[row], result[i], factor);
    }
  }
  return result;
}

RationalMatrix exterior_square(const RationalMatrix& a) {
  const std::size_t size = a.size();
  RationalMatrix square;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = i + 1; j < size; ++j) square.push_back(minors(a[i], a[j]));
  }
  return square;
}

RationalVector minors(const RationalVector& x, const RationalVector& y) {
  RationalVector result;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = i + 1; j < x.size(); ++j) result.push_back(x[i] * y[j] - x[j] * y[i]);
  }
  return result;
}

std::size_t minor_index(std::size_t i, std::size_t j, std::size_t size) {
  return i * size - i * (i + 1) / 2 + (j - i - 1);
}

}  // namespace zenosphere
