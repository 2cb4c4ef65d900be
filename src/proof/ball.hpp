#pragma once

#include <arb.h>

#include "proof/invariant_cone.hpp"
#include "proof/rational.hpp"

namespace zenosphere {

/// A binary number of Arb, exactly.
Rational exact(const arf_t number);

/// How many bits the midpoints of balls have while this lives, in this thread.
class BallPrecision {
 public:
  explicit BallPrecision(long bits) : before_(current()) { current() = bits; }
  ~BallPrecision() { current() = before_; }
  BallPrecision(const BallPrecision&) = delete;
  BallPrecision& operator=(const BallPrecision&) = delete;

  static long& current();

 private:
  long before_;
};

/// A real number that is known to lie in an interval: midpoint and radius, rounded outwards by
/// every operation. What holds for the balls holds for the numbers. Source: F. Johansson, Arb, IEEE
/// Trans. Comput. 66 (2017) 1281.
class Ball {
 public:
  Ball() { arb_init(value_); }
  Ball(long value) : Ball() { arb_set_si(value_, value); }  // NOLINT: as a number
  explicit Ball(const Rational& value);
  Ball(const Ball& other) : Ball() { arb_set(value_, other.value_); }
  Ball(Ball&& other) noexcept : Ball() { arb_swap(value_, other.value_); }
  Ball& operator=(Ball other) noexcept {
    arb_swap(value_, other.value_);
    return *this;
  }
  ~Ball() { arb_clear(value_); }

  Ball& operator+=(const Ball& other) {
    arb_add(value_, value_, other.value_, BallPrecision::current());
    return *this;
  }
  Ball& operator-=(const Ball& other) {
    arb_sub(value_, value_, other.value_, BallPrecision::current());
    return *this;
  }
  Ball& operator*=(const Ball& other) {
    arb_mul(value_, value_, other.value_, BallPrecision::current());
    return *this;
  }
  Ball& operator/=(const Ball& other) {
    arb_div(value_, value_, other.value_, BallPrecision::current());
    return *this;
  }
  friend Ball operator+(Ball a, const Ball& b) { return std::move(a += b); }
  friend Ball operator-(Ball a, const Ball& b) { return std::move(a -= b); }
  friend Ball operator*(Ball a, const Ball& b) { return std::move(a *= b); }
  friend Ball operator/(Ball a, const Ball& b) { return std::move(a /= b); }
  friend Ball square_root(Ball a) {
    arb_sqrt(a.value_, a.value_, BallPrecision::current());
    return a;
  }

  /// Certainly so; where neither holds the sign is not known.
  bool is_positive() const { return arb_is_positive(value_) != 0; }
  bool is_negative() const { return arb_is_negative(value_) != 0; }
  /// Certainly less.
  friend bool is_less(const Ball& a, const Ball& b) { return arb_lt(a.value_, b.value_) != 0; }
  /// The order of the midpoints: a guess.
  friend bool seems_less(const Ball& a, const Ball& b) {
    return arf_cmp(arb_midref(a.value_), arb_midref(b.value_)) < 0;
  }
  /// The midpoint alone, which is exact.
  Ball midpoint() const {
    Ball middle;
    arf_set(arb_midref(middle.value_), arb_midref(value_));
    return middle;
  }
  /// The ends of the interval, or numbers outside it; the ball is finite.
  Enclosure ends() const;
  bool is_finite() const { return arb_is_finite(value_) != 0; }

 private:
  arb_t value_;
};

}  // namespace zenosphere
