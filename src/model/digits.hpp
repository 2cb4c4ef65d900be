#pragma once

#include <mpfr.h>

#include <boost/multiprecision/float128.hpp>
#include <compare>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <iosfwd>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>

#include "model/digits_parts.hpp"
#include "model/precision.hpp"

namespace zenosphere {

/// A floating-point number whose significand is as long as the run wants it: MPFR's, in a value.
///
/// New numbers have the working precision of the thread (see WorkingPrecision); a result has that
/// of the longer operand, and is rounded correctly, to even. Up to `bits_in_place` the significand
/// is part of the object, which nearly halves the cost of a hundred digits.
///
/// Source: Fousse et al., ACM Trans. Math. Softw. 33 (2007) 13 (MPFR).
class Digits {
 public:
  Digits() : Digits(Unset{}, working_bits) { mpfr_set_zero(value_, 1); }

  template <class Number>
  requires std::is_arithmetic_v<Number> Digits(Number number)  // NOLINT: as a double is made
      : Digits(Unset{}, working_bits) {
    set(number);
  }
  template <std::same_as<boost::multiprecision::float128> Quad>  // and nothing that becomes one
  explicit Digits(const Quad& number) : Digits() {
    set_quad(number);
  }

  /// Throws std::runtime_error for a text that is no number.
  explicit Digits(const std::string& decimal);

  Digits(const Digits& other) { copy(other); }
  Digits(Digits&& other) noexcept { take(other); }
  Digits& operator=(const Digits& other) {
    if (this == &other) return *this;
    if (!is_in_place(bits()) || !is_in_place(other.bits())) return assign_long(other);
    copy(other);
    return *this;
  }
  Digits& operator=(Digits&& other) noexcept {
    if (this == &other) return *this;
    drop();
    take(other);
    return *this;
  }
  ~Digits() { drop(); }

  /// The same number with the working precision, or the next to it where that is shorter.
  Digits in_working_precision() const;

  /// Of its significand.
  int bits() const { return static_cast<int>(mpfr_get_prec(value_)); }

  template <class Number>
  requires std::is_arithmetic_v<Number>
  explicit operator Number() const {
    if constexpr (std::is_integral_v<Number>) {
      return static_cast<Number>(mpfr_get_si(value_, MPFR_RNDZ));
    } else if constexpr (std::is_same_v<Number, long double>) {
      return mpfr_get_ld(value_, MPFR_RNDN);
    } else {
      return static_cast<Number>(mpfr_get_d(value_, MPFR_RNDN));
    }
  }
  explicit operator boost::multiprecision::float128() const { return quad(); }

  /// Decimal text, as `%g` writes it: of so many significant digits, or of all that its bits tell
  /// apart.
  std::string str(int digits) const;
  std::string str() const { return str(bits() * 301 / 1000 + 3); }

  Digits operator-() const {
    Digits result(Unset{}, bits());
    mpfr_neg(result.value_, value_, MPFR_RNDN);
    return result;
  }

  friend Digits operator+(const Digits& a, const Digits& b) { return result_of(mpfr_add, a, b); }
  friend Digits operator-(const Digits& a, const Digits& b) { return result_of(mpfr_sub, a, b); }
  friend Digits operator*(const Digits& a, const Digits& b) { return result_of(mpfr_mul, a, b); }
  friend Digits operator/(const Digits& a, const Digits& b) { return result_of(mpfr_div, a, b); }

  template <std::signed_integral Integer>
  friend Digits operator*(const Digits& a, Integer b) {
    return result_of(mpfr_mul_si, a, b);
  }
  template <std::signed_integral Integer>
  friend Digits operator*(Integer a, const Digits& b) {
    return result_of(mpfr_mul_si, b, a);
  }
  template <std::signed_integral Integer>
  friend Digits operator/(const Digits& a, Integer b) {
    return result_of(mpfr_div_si, a, b);
  }

  Digits& operator+=(const Digits& other) { return change(mpfr_add, other); }
  Digits& operator-=(const Digits& other) { return change(mpfr_sub, other); }
  Digits& operator*=(const Digits& other) { return change(mpfr_mul, other); }
  Digits& operator/=(const Digits& other) { return change(mpfr_div, other); }

  friend bool operator==(const Digits& a, const Digits& b) {
    return mpfr_equal_p(a.value_, b.value_) != 0;
  }
  friend std::partial_ordering operator<=>(const Digits& a, const Digits& b) {
    if (isnan(a) || isnan(b)) return std::partial_ordering::unordered;
    return mpfr_cmp(a.value_, b.value_) <=> 0;
  }
  template <class Number>
  requires std::is_arithmetic_v<Number>
  friend bool operator==(const Digits& a, Number b) { return (a <=> b) == 0; }
  template <class Number>
  requires std::is_arithmetic_v<Number>
  friend std::partial_ordering operator<=>(const Digits& a, Number b) {
    if constexpr (std::is_same_v<Number, long double>) {
      return a <=> Digits(b);
    } else if constexpr (std::is_floating_point_v<Number>) {
      if (isnan(a) || b != b) return std::partial_ordering::unordered;
      return mpfr_cmp_d(a.value_, b) <=> 0;
    } else if (isnan(a)) {
      return std::partial_ordering::unordered;
    } else if constexpr (std::is_unsigned_v<Number>) {
      return mpfr_cmp_ui(a.value_, b) <=> 0;
    } else {
      return mpfr_cmp_si(a.value_, b) <=> 0;
    }
  }

  friend bool isnan(const Digits& x) { return mpfr_nan_p(x.value_) != 0; }
  friend bool isinf(const Digits& x) { return mpfr_inf_p(x.value_) != 0; }
  friend bool isfinite(const Digits& x) { return mpfr_number_p(x.value_) != 0; }
  friend bool signbit(const Digits& x) { return mpfr_signbit(x.value_) != 0; }

  friend Digits abs(const Digits& x) { return result_of(mpfr_abs, x); }
  friend Digits sqrt(const Digits& x) { return result_of(mpfr_sqrt, x); }
  friend Digits log(const Digits& x) { return result_of(mpfr_log, x); }
  friend Digits log10(const Digits& x) { return result_of(mpfr_log10, x); }
  friend Digits floor(const Digits& x) {
    Digits result(Unset{}, x.bits());
    mpfr_floor(result.value_, x.value_);
    return result;
  }

  /// x = result 2^exponent, the result in [1/2, 1) but for 0.
  friend Digits frexp(const Digits& x, int* exponent);
  friend Digits ldexp(const Digits& x, int exponent) {
    Digits result(Unset{}, x.bits());
    mpfr_mul_2si(result.value_, x.value_, exponent, MPFR_RNDN);
    return result;
  }

  friend DigitsParts parts_of(const Digits& number);
  friend std::optional<Digits> composed(const DigitsParts& parts, int bits);

 private:
  friend class WorkingPrecision;

  static constexpr int bits_in_place = 384;  ///< a hundred digits take 334
  static constexpr int default_bits = bits_of_digits(100);
  static constexpr std::size_t limbs_in_place = bits_in_place / 64;
  static_assert(sizeof(mp_limb_t) == 8);
  static inline constinit thread_local int working_bits = default_bits;

  struct Unset {};
  Digits(Unset, int bits) {
    void* place = is_in_place(bits) ? here_ : ::operator new(bytes_of(bits));
    mpfr_custom_init_set(value_, MPFR_NAN_KIND, 0, bits, place);
  }

  static bool is_in_place(int bits) { return bits <= bits_in_place; }
  static std::size_t bytes_of(int bits) { return mpfr_custom_get_size(bits); }
  const void* limbs() const { return mpfr_custom_get_significand(value_); }

  /// Becomes a copy; it holds no memory of its own.
  void copy(const Digits& other) {
    value_[0] = other.value_[0];
    if (is_in_place(bits())) {
      std::memcpy(here_, other.here_, sizeof here_);
      mpfr_custom_move(value_, here_);
      return;
    }
    copy_long(other);
  }
  void copy_long(const Digits& other);
  Digits& assign_long(const Digits& other);

  /// Becomes the other, which is left without a value; it holds no memory of its own.
  void take(Digits& other) {
    value_[0] = other.value_[0];
    if (is_in_place(bits())) {
      std::memcpy(here_, other.here_, sizeof here_);
      mpfr_custom_move(value_, here_);
    } else {
      mpfr_custom_move(other.value_, nullptr);
    }
  }

  void drop() {
    if (!is_in_place(bits())) ::operator delete(mpfr_custom_get_significand(value_));
  }

  void set_quad(const boost::multiprecision::float128& number);
  boost::multiprecision::float128 quad() const;

  template <class Number>
  void set(Number number) {
    if constexpr (std::is_same_v<Number, long double>) {
      mpfr_set_ld(value_, number, MPFR_RNDN);
    } else if constexpr (std::is_floating_point_v<Number>) {
      mpfr_set_d(value_, number, MPFR_RNDN);
    } else if constexpr (std::is_unsigned_v<Number>) {
      mpfr_set_ui(value_, number, MPFR_RNDN);
    } else {
      mpfr_set_si(value_, number, MPFR_RNDN);
    }
  }

  template <class Operation>
  static Digits result_of(Operation operation, const Digits& a, const Digits& b) {
    Digits result(Unset{}, a.bits() < b.bits() ? b.bits() : a.bits());
    operation(result.value_, a.value_, b.value_, MPFR_RNDN);
    return result;
  }
  template <class Operation>
  static Digits result_of(Operation operation, const Digits& a, long b) {
    Digits result(Unset{}, a.bits());
    operation(result.value_, a.value_, b, MPFR_RNDN);
    return result;
  }
  template <class Operation>
  static Digits result_of(Operation operation, const Digits& x) {
    Digits result(Unset{}, x.bits());
    operation(result.value_, x.value_, MPFR_RNDN);
    return result;
  }
  template <class Operation>
  Digits& change(Operation operation, const Digits& other) {
    if (bits() < other.bits()) return *this = result_of(operation, *this, other);
    operation(value_, value_, other.value_, MPFR_RNDN);
    return *this;
  }

  mpfr_t value_;
  mp_limb_t here_[limbs_in_place];  ///< the significand, if it is short enough
};

/// Every number has one form.
DigitsParts parts_of(const Digits& number);

/// The number of so many bits that parts_of() took apart; nothing if there is none.
std::optional<Digits> composed(const DigitsParts& parts, int bits);

/// While it lives, numbers that this thread makes have so many bits.
class WorkingPrecision {
 public:
  /// \param bits  of the significand
  explicit WorkingPrecision(int bits) : before_(Digits::working_bits) {
    Digits::working_bits = bits;
  }
  ~WorkingPrecision() { Digits::working_bits = before_; }
  WorkingPrecision(const WorkingPrecision&) = delete;
  WorkingPrecision& operator=(const WorkingPrecision&) = delete;

  /// Of the thread now.
  static int bits() { return Digits::working_bits; }

 private:
  int before_;
};

std::ostream& operator<<(std::ostream& stream, const Digits& number);

}  // namespace zenosphere

/// What depends on the working precision is a function here; `digits` is significand_bits().
template <>
class std::numeric_limits<zenosphere::Digits> {
 public:
  static constexpr bool is_specialized = true;
  static constexpr bool is_integer = false;
  static constexpr int max_exponent = std::numeric_limits<int>::max();

  static zenosphere::Digits epsilon() {
    return ldexp(zenosphere::Digits(1), 1 - zenosphere::WorkingPrecision::bits());
  }
  static zenosphere::Digits infinity() { return std::numeric_limits<double>::infinity(); }
  static zenosphere::Digits quiet_NaN() { return std::numeric_limits<double>::quiet_NaN(); }
};
