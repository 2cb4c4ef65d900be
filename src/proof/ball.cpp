#include "proof/ball.hpp"

#include <cstdlib>

namespace zenosphere {

Rational exact(const arf_t number) {
  fmpz_t mantissa;
  fmpz_t exponent;
  fmpz_init(mantissa);
  fmpz_init(exponent);
  arf_get_fmpz_2exp(mantissa, exponent, number);
  Integer digits;
  fmpz_get_mpz(digits.get_mpz_t(), mantissa);
  const slong shift = fmpz_get_si(exponent);
  fmpz_clear(mantissa);
  fmpz_clear(exponent);
  Rational value(digits);
  const auto bits = static_cast<mp_bitcnt_t>(std::labs(shift));
  if (shift < 0) {
    mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), bits);
  } else {
    mpq_mul_2exp(value.get_mpq_t(), value.get_mpq_t(), bits);
  }
  return value;
}

long& BallPrecision::current() {
  thread_local long bits = 256;
  return bits;
}

Ball::Ball(const Rational& value) : Ball() {
  fmpq_t copy;
  fmpq_init(copy);
  fmpq_set_mpq(copy, value.get_mpq_t());
  arb_set_fmpq(value_, copy, BallPrecision::current());
  fmpq_clear(copy);
}

Enclosure Ball::ends() const {
  arf_t end;
  arf_init(end);
  Enclosure result;
  arb_get_lbound_arf(end, value_, BallPrecision::current());
  result.lower = exact(end);
  arb_get_ubound_arf(end, value_, BallPrecision::current());
  result.upper = exact(end);
  arf_clear(end);
  return result;
}

}  // namespace zenosphere
