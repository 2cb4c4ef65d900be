#include <compare>
#include <cstring>

#include "model/digits.hpp"

namespace zenosphere {

Digits::Digits() : Digits(Unset{}, working_bits) { mpfr_set_zero(value_, 1); }

Digits::Digits(Unset, int bits) {
  void* place = is_in_place(bits) ? here_ : ::operator new(bytes_of(bits));
  mpfr_custom_init_set(value_, MPFR_NAN_KIND, 0, bits, place);
}

Digits::Digits(const Digits& other) { copy(other); }

Digits::Digits(Digits&& other) noexcept { take(other); }

Digits& Digits::operator=(const Digits& other) {
  if (this == &other) return *this;
  const bool keeps_memory = !is_in_place(bits()) && bits() == other.bits();
  if (keeps_memory && limbs() && other.limbs()) {
    mpfr_set(value_, other.value_, MPFR_RNDN);
    return *this;
  }
  drop();
  copy(other);
  return *this;
}

Digits& Digits::operator=(Digits&& other) noexcept {
  if (this == &other) return *this;
  drop();
  take(other);
  return *this;
}

void Digits::copy(const Digits& other) {
  value_[0] = other.value_[0];
  if (is_in_place(bits())) {
    std::memcpy(here_, other.here_, sizeof here_);
    mpfr_custom_move(value_, here_);
    return;
  }
  const std::size_t bytes = bytes_of(bits());
  void* place = ::operator new(bytes);
  if (other.limbs()) std::memcpy(place, other.limbs(), bytes);
  mpfr_custom_move(value_, place);
}

void Digits::take(Digits& other) {
  value_[0] = other.value_[0];
  if (is_in_place(bits())) {
    std::memcpy(here_, other.here_, sizeof here_);
    mpfr_custom_move(value_, here_);
  } else {
    mpfr_custom_move(other.value_, nullptr);
  }
}

template <class Operation>
Digits Digits::result_of(Operation operation, const Digits& a, const Digits& b) {
  Digits result(Unset{}, a.bits() < b.bits() ? b.bits() : a.bits());
  operation(result.value_, a.value_, b.value_, MPFR_RNDN);
  return result;
}

template <class Operation>
Digits Digits::result_of(Operation operation, const Digits& x) {
  Digits result(Unset{}, x.bits());
  operation(result.value_, x.value_, MPFR_RNDN);
  return result;
}

template <class Operation>
Digits& Digits::change(Operation operation, const Digits& other) {
  if (bits() < other.bits()) return *this = result_of(operation, *this, other);
  operation(value_, value_, other.value_, MPFR_RNDN);
  return *this;
}

Digits Digits::operator-() const { return result_of(mpfr_neg, *this); }

Digits operator+(const Digits& a, const Digits& b) { return Digits::result_of(mpfr_add, a, b); }
Digits operator-(const Digits& a, const Digits& b) { return Digits::result_of(mpfr_sub, a, b); }
Digits operator*(const Digits& a, const Digits& b) { return Digits::result_of(mpfr_mul, a, b); }
Digits operator/(const Digits& a, const Digits& b) { return Digits::result_of(mpfr_div, a, b); }

Digits Digits::times(const Digits& a, long b) {
  Digits result(Unset{}, a.bits());
  mpfr_mul_si(result.value_, a.value_, b, MPFR_RNDN);
  return result;
}

Digits Digits::divided(const Digits& a, long b) {
  Digits result(Unset{}, a.bits());
  mpfr_div_si(result.value_, a.value_, b, MPFR_RNDN);
  return result;
}

Digits& Digits::operator+=(const Digits& other) { return change(mpfr_add, other); }
Digits& Digits::operator-=(const Digits& other) { return change(mpfr_sub, other); }
Digits& Digits::operator*=(const Digits& other) { return change(mpfr_mul, other); }
Digits& Digits::operator/=(const Digits& other) { return change(mpfr_div, other); }

bool operator==(const Digits& a, const Digits& b) { return mpfr_equal_p(a.value_, b.value_) != 0; }

std::partial_ordering operator<=>(const Digits& a, const Digits& b) {
  if (isnan(a) || isnan(b)) return std::partial_ordering::unordered;
  return mpfr_cmp(a.value_, b.value_) <=> 0;
}

std::partial_ordering Digits::compared(const Digits& a, double b) {
  if (isnan(a) || b != b) return std::partial_ordering::unordered;
  return mpfr_cmp_d(a.value_, b) <=> 0;
}

Digits abs(const Digits& x) { return Digits::result_of(mpfr_abs, x); }
Digits sqrt(const Digits& x) { return Digits::result_of(mpfr_sqrt, x); }
Digits log(const Digits& x) { return Digits::result_of(mpfr_log, x); }
Digits log10(const Digits& x) { return Digits::result_of(mpfr_log10, x); }

Digits floor(const Digits& x) {
  Digits result(Digits::Unset{}, x.bits());
  mpfr_floor(result.value_, x.value_);
  return result;
}

Digits ldexp(const Digits& x, int exponent) {
  Digits result(Digits::Unset{}, x.bits());
  mpfr_mul_2si(result.value_, x.value_, exponent, MPFR_RNDN);
  return result;
}

}  // namespace zenosphere
