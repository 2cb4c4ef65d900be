#include "model/precision.hpp"

#include <charconv>

namespace zenosphere {

namespace {

constexpr std::string_view digits_word = "digits";

}  // namespace

std::optional<Precision> Precision::from_word(std::string_view word) {
  for (const Precision named : {double_precision, extended, quad}) {
    if (word == named.word()) return named;
  }
  if (!word.starts_with(digits_word)) return std::nullopt;
  int decimal = 0;
  const std::string_view number = word.substr(digits_word.size());
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), decimal);
  if (error != std::errc() || decimal < fewest_digits || decimal > most_digits) return std::nullopt;
  const Precision precision = digits(decimal);
  if (precision.word() != word) return std::nullopt;  // digits0100, digits100x
  return precision;
}

std::string Precision::word() const {
  if (is_digits()) return std::string(digits_word) + std::to_string(decimal_);
  return *this == quad ? "quad" : *this == extended ? "extended" : "double";
}

bool is_precision_of_bits(int bits) {
  for (const Precision named :
       {Precision::double_precision, Precision::extended, Precision::quad}) {
    if (bits == named.bits()) return true;
  }
  return bits >= bits_of_digits(fewest_digits) && bits <= bits_of_digits(most_digits);
}

}  // namespace zenosphere
