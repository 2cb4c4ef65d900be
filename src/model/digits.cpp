#include "model/digits.hpp"

#include <algorithm>
#include <ostream>
#include <stdexcept>

namespace zenosphere {

using Quad = boost::multiprecision::float128;

namespace {

constexpr int doubles_in_quad = 3;  // 159 bits hold the 113

}  // namespace

void Digits::set_quad(const Quad& number) {
  if (!isfinite(number)) {
    *this = Digits(static_cast<double>(number));
    return;
  }
  int exponent = 0;
  Quad rest = frexp(number, &exponent);  // each part is in the range of double
  for (int part = 0; part < doubles_in_quad; ++part) {
    const auto leading = static_cast<double>(rest);
    *this = part == 0 ? Digits(leading) : *this + leading;  // a sum would lose the sign of zero
    rest -= leading;
  }
  mpfr_mul_2si(value_, value_, exponent, MPFR_RNDN);
}

Quad Digits::quad() const {
  if (!isfinite(*this)) return static_cast<double>(*this);
  int exponent = 0;
  Digits rest = frexp(*this, &exponent);
  Quad sum = 0;
  for (int part = 0; part < doubles_in_quad; ++part) {
    const auto leading = static_cast<double>(rest);
    sum = part == 0 ? Quad(leading) : Quad(sum + leading);
    rest -= leading;
  }
  return ldexp(sum, exponent);
}

Digits::Digits(const std::string& decimal) : Digits(Unset{}, working_bits) {
  if (mpfr_set_str(value_, decimal.c_str(), 10, MPFR_RNDN) != 0) {
    throw std::runtime_error("no number: " + decimal);
  }
}

std::string Digits::str(int digits) const {
  const int size = mpfr_snprintf(nullptr, 0, "%.*Rg", digits, value_);
  std::string text(static_cast<std::size_t>(size), '\0');
  mpfr_snprintf(text.data(), text.size() + 1, "%.*Rg", digits, value_);
  return text;
}

Digits frexp(const Digits& x, int* exponent) {
  Digits result(Digits::Unset{}, x.bits());
  mpfr_exp_t power = 0;
  mpfr_frexp(&power, result.value_, x.value_, MPFR_RNDN);
  *exponent = static_cast<int>(power);
  return result;
}

Digits Digits::in_working_precision() const {
  Digits result(Unset{}, working_bits);
  mpfr_set(result.value_, value_, MPFR_RNDN);
  return result;
}

DigitsParts parts_of(const Digits& number) {
  DigitsParts parts{.negative = signbit(number), .words = {}};
  parts.words.resize(words_of_bits(number.bits()));
  if (isnan(number)) parts.kind = NumberKind::not_a_number;
  if (isinf(number)) parts.kind = NumberKind::infinite;
  if (!isfinite(number) || number == 0) return parts;
  parts.exponent = static_cast<std::int32_t>(mpfr_get_exp(number.value_));
  const auto* limbs = static_cast<const mp_limb_t*>(number.limbs());
  std::size_t limb = (static_cast<std::size_t>(number.bits()) + 63) / 64;  // the highest is last
  for (std::size_t word = 0; word < parts.words.size(); ++word) {
    if (word % 2 == 0) --limb;
    parts.words[word] = static_cast<std::uint32_t>(limbs[limb] >> (word % 2 == 0 ? 32 : 0));
  }
  return parts;
}

std::optional<Digits> composed(const DigitsParts& parts, int bits) {
  Digits number(Digits::Unset{}, bits);
  const auto& words = parts.words;
  const int sign = parts.negative ? -1 : 1;
  if (parts.kind == NumberKind::not_a_number) {
    mpfr_set_nan(number.value_);
    mpfr_setsign(number.value_, number.value_, parts.negative ? 1 : 0, MPFR_RNDN);
  } else if (parts.kind == NumberKind::infinite) {
    mpfr_set_inf(number.value_, sign);
  } else if (std::all_of(words.begin(), words.end(),
                         [](std::uint32_t word) { return word == 0; })) {
    mpfr_set_zero(number.value_, sign);
  } else {
    const int spare = static_cast<int>(words.size()) * 32 - bits;
    if (words.size() != words_of_bits(bits) || words.front() >> 31 == 0) return std::nullopt;
    if ((words.back() & ((std::uint32_t{1} << spare) - 1)) != 0) return std::nullopt;
    mpfr_custom_init_set(number.value_, sign * MPFR_REGULAR_KIND, parts.exponent, bits,
                         mpfr_custom_get_significand(number.value_));
    auto* limbs = static_cast<mp_limb_t*>(mpfr_custom_get_significand(number.value_));
    std::size_t limb = (words.size() + 1) / 2;
    for (std::size_t word = 0; word < words.size(); ++word) {
      if (word % 2 == 0) limbs[--limb] = mp_limb_t{words[word]} << 32;
      if (word % 2 == 1) limbs[limb] |= words[word];
    }
  }
  return number;
}

std::ostream& operator<<(std::ostream& stream, const Digits& number) {
  return stream << number.str();
}

}  // namespace zenosphere
