#include "proof/rational.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "model/errors.hpp"

namespace zenosphere {

namespace {

[[noreturn]] void refuse(const std::string& text) {
  throw InputError("exact number: \"" + text + "\" (is not a number); write it like 0.05 or 40/11");
}

Integer power_of_ten(unsigned long exponent) {
  Integer power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, exponent);
  return power;
}

/// The number of a text of digits alone.
Integer whole(const std::string& digits, const std::string& text) {
  const bool is_whole = !digits.empty() && digits.find_first_not_of("0123456789") == digits.npos;
  if (!is_whole) refuse(text);
  return Integer(digits, 10);
}

/// The exponent after an "e", which is cut off.
long cut_exponent(std::string& number, const std::string& text) {
  const auto e = number.find_first_of("eE");
  if (e == number.npos) return 0;
  constexpr long largest_exponent = 100000;
  char* end = nullptr;
  const std::string exponent = number.substr(e + 1);
  const long value = std::strtol(exponent.c_str(), &end, 10);
  if (exponent.empty() || *end != '\0' || std::labs(value) > largest_exponent) refuse(text);
  number.resize(e);
  return value;
}

Rational unsigned_decimal(std::string number, const std::string& text) {
  long exponent = cut_exponent(number, text);
  if (const auto point = number.find('.'); point != number.npos) {
    number.erase(point, 1);
    exponent -= static_cast<long>(number.size() - point);
  }
  const Integer digits = whole(number, text);
  const Integer power = power_of_ten(static_cast<unsigned long>(std::labs(exponent)));
  Rational value = exponent < 0 ? Rational(digits, power) : Rational(digits * power);
  value.canonicalize();
  return value;
}

/// value, an integer, as a decimal number with its last `places` digits after the point.
std::string with_point(const Integer& value, int places) {
  std::string digits = Integer(abs(value)).get_str();
  const auto least = static_cast<std::size_t>(places) + 1;
  if (digits.size() < least) digits.insert(0, least - digits.size(), '0');
  if (places > 0) digits.insert(digits.size() - static_cast<std::size_t>(places), 1, '.');
  if (value < 0) digits.insert(0, 1, '-');
  return digits;
}

}  // namespace

Rational exact_number(const std::string& text) {
  const std::size_t sign = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  const auto slash = text.find('/');
  Rational value;
  if (slash == text.npos) {
    value = unsigned_decimal(text.substr(sign), text);
  } else {
    const Integer denominator = whole(text.substr(slash + 1), text);
    if (denominator == 0) refuse(text);
    value = Rational(whole(text.substr(sign, slash - sign), text), denominator);
    value.canonicalize();
  }
  return text[0] == '-' ? Rational(-value) : value;
}

std::string decimal_below(const Rational& value, int places) {
  const Rational scaled = value * power_of_ten(static_cast<unsigned long>(places));
  Integer quotient;
  mpz_fdiv_q(quotient.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  return with_point(quotient, places);
}

std::string decimal_above(const Rational& value, int places) {
  const Rational scaled = value * power_of_ten(static_cast<unsigned long>(places));
  Integer quotient;
  mpz_cdiv_q(quotient.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  return with_point(quotient, places);
}

int places_for(const Rational& width) { return std::max(0, 1 - decimal_exponent(width)); }

int decimal_exponent(const Rational& value) {
  long top = 0;
  long bottom = 0;
  const double numerator = mpz_get_d_2exp(&top, value.get_num_mpz_t());
  const double denominator = mpz_get_d_2exp(&bottom, value.get_den_mpz_t());
  const double bits = std::log2(numerator / denominator) + static_cast<double>(top - bottom);
  return static_cast<int>(std::floor(bits * std::log10(2.0)));
}

}  // namespace zenosphere
