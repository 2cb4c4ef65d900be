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
/// Its operations are functions in a source of their own: a call costs little beside them, and
/// where they stand in the engine's code, that takes twice as long to compile.
///
/// Source: Fousse et al., ACM Trans. Math. Softw. 33 (2007) 13 (MPFR).
class Digits {
 public:
  Digits();

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

  Digits(const Digits& other);
  Digits(Digits&& other) noexcept;
  Digits& operator=(const Digits& other);
  Digits& operator=(Digits&& other) noexcept;
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

  Digits operator-() const;

  friend Digits operator+(const Digits& a, const Digits& b);
  friend Digits operator-(const Digits& a, const Digits& b);
  friend Digits operator*(const Digits& a, const Digits& b);
  friend Digits operator/(const Digits& a, const Digits& b);

  template <std::signed_integral Integer>
  friend Digits operator*(const Digits& a, Integer b) {
    return times(a, b);
  }
  template <std::signed_integral Integer>
  friend Digits operator*(Integer a, const Digits& b) {
    return times(b, a);
  }
  template <std::signed_integral Integer>
  friend Digits operator/(const Digits& a, Integer b) {
    return divided(a, b);
  }

  Digits& operator+=(const Digits& other);
  Digits& operator-=(const Digits& other);
  Digits& operator*=(const Digits& other);
  Digits& operator/=(const Digits& other);

  friend bool operator==(const Digits& a, const Digits& b);
  friend std::partial_ordering operator<=>(const Digits& a, const Digits& b);
  template <class Number>
  requires std::is_arithmetic_v<Number>
  friend bool operator==(const Digits& a, Number b) { return (a <=> b) == 0; }
  template <class Number>
  requires std::is_arithmetic_v<Number>
  friend std::partial_ordering operator<=>(const Digits& a, Number b) {
    if constexpr (std::is_same_v<Number, long double>) {
      return a <=> Digits(b);
    } else if constexpr (std::is_floating_point_v<Number>) {
      return compared(a, static_cast<double>(b));
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

  friend Digits abs(const Digits& x);
  friend Digits sqrt(const Digits& x);
  friend Digits log(const Digits& x);
  friend Digits log10(const Digits& x);
  friend Digits floor(const Digits& x);

  /// x = result 2^exponent, the result in [1/2, 1) but for 0.
  friend Digits frexp(const Digits& x, int* exponent);
  friend Digits ldexp(const Digits& x, int exponent);

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
  Digits(Unset, int bits);

  static bool is_in_place(int bits) { return bits <= bits_in_place; }
  static std::size_t bytes_of(int bits) { return mpfr_custom_get_size(bits); }
  const void* limbs() const { return mpfr_custom_get_significand(value_); }

  /// Becomes a copy; it holds no memory of its own.
  void copy(const Digits& other);

  /// Becomes the other, which is left without a value; it holds no memory of its own.
  void take(Digits& other);

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
  static Digits result_of(Operation operation, const Digits& a, const Digits& b);
  template <class Operation>
  static Digits result_of(Operation operation, const Digits& x);
  template <class Operation>
  Digits& change(Operation operation, const Digits& other);
  static Digits times(const Digits& a, long b);
  static Digits divided(const Digits& a, long b);
  static std::partial_ordering compared(const Digits& a, double b);

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
