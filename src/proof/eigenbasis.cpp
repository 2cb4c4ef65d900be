#include "proof/eigenbasis.hpp"

#include <acb_mat.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
#include <vector>

#include "proof/ball.hpp"

namespace zenosphere {

namespace {

constexpr slong precision_bits = 256;

/// A complex matrix of Arb, with its memory.
class ComplexMatrix {
 public:
  explicit ComplexMatrix(std::size_t size) {
    acb_mat_init(value_, static_cast<slong>(size), static_cast<slong>(size));
  }
  ~ComplexMatrix() { acb_mat_clear(value_); }
  ComplexMatrix(const ComplexMatrix&) = delete;
  ComplexMatrix& operator=(const ComplexMatrix&) = delete;

  acb_mat_struct* value() { return value_; }
  acb_ptr at(std::size_t i, std::size_t j) {
    return acb_mat_entry(value_, static_cast<slong>(i), static_cast<slong>(j));
  }

 private:
  acb_mat_t value_;
};

void assign(arb_t to, const Rational& value) {
  fmpq_t copy;
  fmpq_init(copy);
  fmpq_set_mpq(copy, value.get_mpq_t());
  arb_set_fmpq(to, copy, precision_bits);
  fmpq_clear(copy);
}

/// The midpoint of a ball, as the exact binary number that it is.
Rational midpoint(const arb_t ball) { return exact(arb_midref(ball)); }

struct Eigenvalue {
  Rational real;
  Rational imaginary;
  Rational square;  ///< of the modulus
  std::size_t column;

  /// Not a rounding error of a real one.
  bool is_complex() const {
    Rational bound = square;
    mpq_div_2exp(bound.get_mpq_t(), bound.get_mpq_t(), precision_bits / 2);
    return imaginary * imaginary > bound;
  }
};

/// Largest first.
std::vector<Eigenvalue> sorted(acb_ptr values, std::size_t count) {
  std::vector<Eigenvalue> result;
  for (std::size_t k = 0; k < count; ++k) {
    Eigenvalue value{midpoint(acb_realref(values + k)), midpoint(acb_imagref(values + k)), 0, k};
    value.square = value.real * value.real + value.imaginary * value.imaginary;
    result.push_back(value);
  }
  std::sort(result.begin(), result.end(),
            [](const Eigenvalue& a, const Eigenvalue& b) { return a.square > b.square; });
  return result;
}

/// Real and imaginary part of one vector stand for it and its conjugate, which is the next one (or,
/// if moduli coincide, is not: then the basis may be singular, which the caller notices).
RationalMatrix columns(ComplexMatrix& vectors, const std::vector<Eigenvalue>& values) {
  const std::size_t size = values.size();
  RationalMatrix basis(size, RationalVector(size));
  bool is_second = false;
  for (std::size_t k = 0; k < size; ++k) {
    const std::size_t column = values[is_second ? k - 1 : k].column;
    for (std::size_t i = 0; i < size; ++i) {
      const acb_ptr entry = vectors.at(i, column);
      basis[i][k] = midpoint(is_second ? acb_imagref(entry) : acb_realref(entry));
    }
    is_second = values[k].is_complex() && !is_second;
  }
  return basis;
}

}  // namespace

std::optional<RationalMatrix> eigenbasis(const RationalMatrix& matrix) {
  const std::size_t size = matrix.size();
  ComplexMatrix given(size);
  ComplexMatrix vectors(size);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) assign(acb_realref(given.at(i, j)), matrix[i][j]);
  }
  acb_ptr values = _acb_vec_init(static_cast<slong>(size));
  const int is_found = acb_mat_approx_eig_qr(values, nullptr, vectors.value(), given.value(),
                                             nullptr, 0, precision_bits);
  const std::vector<Eigenvalue> order = sorted(values, size);
  _acb_vec_clear(values, static_cast<slong>(size));
  if (is_found == 0 || order[0].is_complex() || order[0].real <= 0) return std::nullopt;
  if (size > 1 && order[1].square == order[0].square) return std::nullopt;
  return columns(vectors, order);
}

}  // namespace zenosphere
