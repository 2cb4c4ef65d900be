#include "case/case_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "case/case_limits.hpp"
#include "text/printable.hpp"

namespace zenosphere::case_format {
namespace {

using Objection = std::optional<std::string>;

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Cuts the digits off the front of a text, with the underscores that TOML takes between two.
std::string_view next_digits(std::string_view& text) {
  std::size_t count = 0;
  const auto is_digit_at = [&](std::size_t at) { return at < text.size() && is_digit(text[at]); };
  while (is_digit_at(count) ||
         (count > 0 && is_digit_at(count + 1) && is_digit(text[count - 1]) && text[count] == '_')) {
    ++count;
  }
  const std::string_view digits = text.substr(0, count);
  text.remove_prefix(count);
  return digits;
}

bool is_nought(char c) { return c == '0' || c == '_'; }

bool cut(std::string_view& text, std::string_view marks) {
  const bool stands_here = !text.empty() && marks.find(text.front()) != std::string_view::npos;
  if (stands_here) text.remove_prefix(1);
  return stands_here;
}

/// A decimal number, taken apart.
struct Decimal {
  bool is_negative = false;
  std::string_view whole, fraction;
  std::string_view point;     ///< `.`, `,` or empty
  std::string_view exponent;  ///< `e-400` or empty

  bool is_integer() const { return point.empty() && exponent.empty(); }
  bool is_zero() const {
    return std::all_of(whole.begin(), whole.end(), is_nought) &&
           std::all_of(fraction.begin(), fraction.end(), is_nought);
  }
  /// As TOML writes it, without underscores.
  std::string text() const {
    std::string_view digits = whole;
    digits.remove_prefix(std::min(digits.find_first_not_of("0_"), digits.size()));
    std::string text = fmt::format("{}{}{}{}{}", is_negative ? "-" : "",
                                   digits.empty() ? "0" : digits, point.empty() ? "" : ".",
                                   !point.empty() && fraction.empty() ? "0" : fraction, exponent);
    std::erase(text, '_');
    return text;
  }
};

std::optional<Decimal> decimal_in(std::string_view word) {
  Decimal decimal;
  decimal.is_negative = word.starts_with('-');
  cut(word, "+-");
  decimal.whole = next_digits(word);
  const std::string_view from_point = word;
  if (cut(word, ".,")) decimal.point = from_point.substr(0, 1);
  decimal.fraction = next_digits(word);
  const std::string_view from_exponent = word;
  if (cut(word, "eE")) {
    cut(word, "+-");
    if (next_digits(word).empty()) return std::nullopt;
    decimal.exponent = from_exponent;
  }
  const bool has_digits = !decimal.whole.empty() || !decimal.fraction.empty();
  return word.empty() && has_digits ? std::optional(decimal) : std::nullopt;
}

Objection integer_out_of_range(const Decimal& decimal) {
  const std::string text = decimal.text();
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc()) return std::nullopt;
  const double real = std::strtod(text.c_str(), nullptr);
  using Limits = std::numeric_limits<std::int64_t>;
  const std::string limit = decimal.is_negative
                                ? fmt::format("too small: integers are at least {}", Limits::min())
                                : fmt::format("too large: integers are at most {}", Limits::max());
  const bool is_real = !std::isinf(real);
  return fmt::format(
      "({}){}", limit,
      is_real ? fmt::format("; where a real number will do, write {:.17g}", real) : "");
}

Objection real_out_of_range(const Decimal& decimal) {
  const double number = std::strtod(decimal.text().c_str(), nullptr);
  const double least = std::numeric_limits<double>::denorm_min();
  if (std::isinf(number)) {
    return fmt::format("(real numbers are at most {:.3g})", std::numeric_limits<double>::max());
  }
  if (decimal.is_zero() || std::abs(number) >= least) return std::nullopt;
  return fmt::format("(real numbers other than 0 are at least {:.3g}); write 0 or a larger one",
                     least);
}

Objection wrong_form(const Decimal& decimal) {
  const auto write = [&](std::string_view why) {
    return fmt::format("({}); write {}", why, shortened(decimal.text()));
  };
  if (decimal.point == ",") return write("needs a point, not a comma");
  if (decimal.whole.empty()) return write("needs a digit in front of the point");
  if (!decimal.point.empty() && decimal.fraction.empty()) {
    return write("needs a digit behind the point");
  }
  const bool is_padded = decimal.whole.size() > 1 && decimal.whole.front() == '0';
  return is_padded ? Objection(write("begins with 0")) : std::nullopt;
}

/// What a number and what is wrongly taken for one are made of.
bool belongs_to_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
         std::string_view("+-._:").find(c) != std::string_view::npos;
}

/// Where the word ends that begins at `begin`. Outside brackets a comma parts nothing.
std::size_t end_of_word(std::string_view text, std::size_t begin, bool in_brackets) {
  std::size_t at = begin;
  const auto belongs = [&](std::size_t n) {
    const bool is_comma = !in_brackets && text[n] == ',' && n + 1 < text.size() && n > begin;
    return belongs_to_word(text[n]) || (is_comma && is_digit(text[n + 1]));
  };
  while (at < text.size() && belongs(at)) ++at;
  return at;
}

}  // namespace

Objection number_objection(std::string_view word) {
  const auto decimal = decimal_in(word);
  if (!decimal) return std::nullopt;
  Objection objection = wrong_form(*decimal);
  if (!objection) {
    objection =
        decimal->is_integer() ? integer_out_of_range(*decimal) : real_out_of_range(*decimal);
  }
  return objection ? Objection(fmt::format("{} {}", shortened(word), *objection)) : std::nullopt;
}

std::optional<WrongNumber> first_wrong_number(std::string_view text) {
  int depth = 0;
  bool is_value = false;  // what comes next is one
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      at = end_of_string(text, at);
      is_value = false;
    } else if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
    } else if (belongs_to_word(c)) {
      const std::size_t end = end_of_word(text, at, depth > 0);
      const auto wrong = is_value ? number_objection(text.substr(at, end - at)) : std::nullopt;
      if (wrong) return WrongNumber{at, *wrong};
      is_value = false;
      at = end;
    } else {
      const bool opens = c == '[' || c == '{';  // but for the head of a table
      if (opens && (is_value || depth > 0)) ++depth;
      if (c == ']' || c == '}') depth = std::max(depth - 1, 0);
      if (c == '=' || (depth > 0 && (opens || c == ','))) is_value = true;
      if (c == '{' || (c == '\n' && depth == 0)) is_value = false;
      ++at;
    }
  }
  return std::nullopt;
}

}  // namespace zenosphere::case_format
