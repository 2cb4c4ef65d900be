// What a key of a case takes.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "case/case_choices.hpp"
#include "case/case_hints.hpp"
#include "case/case_table.hpp"
#include "text/spelling.hpp"

namespace zenosphere::case_format {
namespace {

/// Why a value cannot be stored; empty if it was.
using Objection = std::optional<std::string>;

Objection wrong_kind(const Value& value, std::string_view needed) {
  return fmt::format("(found {}, needs {})", kind_of(value), needed);
}

template <class Choice>
std::string choices_text() {
  std::string text;
  const auto& words = words_of(Choice{});
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
    text += in_quotes(words[i].text);
  }
  return text;
}

template <class Choice>
Objection no_such_word(const std::string& text) {
  const std::string choices = choices_text<Choice>();
  std::vector<std::string_view> candidates;
  for (const auto& word : words_of(Choice{})) candidates.push_back(word.text);
  if (const auto hint = hint_for_word<Choice>(text)) {
    return fmt::format("(must be {}); {}", choices, *hint);
  }
  const auto meant = nearest(text, candidates);
  return fmt::format("(must be {})", choices) +
         (meant ? fmt::format("; did you mean {}?", in_quotes(*meant)) : "");
}

template <class Choice>
requires std::is_enum_v<Choice> Objection store_in(Choice& slot, const Value& value, const Range&) {
  const auto* text = std::get_if<std::string>(&value);
  if (!text) return wrong_kind(value, "one of the words " + choices_text<Choice>());
  for (const auto& word : words_of(Choice{})) {
    if (word.text != *text) continue;
    slot = word.choice;
    return std::nullopt;
  }
  return no_such_word<Choice>(*text);
}

Objection store_in(Precision& slot, const Value& value, const Range&) {
  static const std::string choices =
      fmt::format("\"double\", \"extended\", \"quad\" or \"digitsN\" with N from {} to {}",
                  fewest_digits, most_digits);
  const auto* text = std::get_if<std::string>(&value);
  if (!text) return wrong_kind(value, "one of the words " + choices);
  const auto precision = Precision::from_word(*text);
  if (precision) {
    slot = *precision;
    return std::nullopt;
  }
  constexpr std::array<std::string_view, 4> words{"double", "extended", "quad", "digits100"};
  const auto meant = text->starts_with("digits") ? std::nullopt : nearest(*text, words);
  return fmt::format("(must be {})", choices) +
         (meant ? fmt::format("; did you mean {}?", in_quotes(*meant)) : "");
}

Objection store_in(double& slot, const Value& value, const Range& range);

/// A number, or the text of one that is too small for `double`.
Objection store_in(GapThreshold& slot, const Value& value, const Range& range) {
  if (const auto* text = std::get_if<std::string>(&value)) {
    const auto threshold = GapThreshold::from_text(*text);
    if (!threshold) return "(must be a number > 0, or the text of one as in \"1e-1000\")";
    slot = *threshold;
    return std::nullopt;
  }
  double number = 0;
  if (auto objection = store_in(number, value, range)) return objection;
  slot = number;
  return std::nullopt;
}

/// A time, or the word for one that is looked for.
Objection store_in(AverageStart& slot, const Value& value, const Range& range) {
  if (const auto* text = std::get_if<std::string>(&value)) {
    if (*text != "auto") return "(must be a number >= 0 or \"auto\")";
    slot = AverageStart::found();
    return std::nullopt;
  }
  double time = 0;
  if (auto objection = store_in(time, value, range)) return objection;
  slot = time;
  return std::nullopt;
}

Objection store_in(bool& slot, const Value& value, const Range&) {
  const auto* boolean = std::get_if<bool>(&value);
  if (!boolean) return wrong_kind(value, "true or false");
  slot = *boolean;
  return std::nullopt;
}

Objection store_in(std::string& slot, const Value& value, const Range&) {
  const auto* text = std::get_if<std::string>(&value);
  if (!text) return wrong_kind(value, "text");
  if (text->empty()) return "(is empty)";
  slot = *text;
  return std::nullopt;
}

/// Why one number, alone or in an array, is wrong.
Objection wrong_number(double number, const Range& range) {
  if (!std::isfinite(number)) return "must be a finite number";
  if (!range.contains(number)) return range_text(range);
  return std::nullopt;
}

Objection store_in(double& slot, const Value& value, const Range& range) {
  double number = 0;
  if (const auto* integer = std::get_if<std::int64_t>(&value)) {
    number = static_cast<double>(*integer);
  } else if (const auto* real = std::get_if<double>(&value)) {
    number = *real;
  } else {
    return wrong_kind(value, "a real number");
  }
  if (const auto wrong = wrong_number(number, range)) return fmt::format("({})", *wrong);
  slot = number;
  return std::nullopt;
}

/// A number, or the word for what nothing bounds.
Objection store_in(Friction& slot, const Value& value, const Range& range) {
  const auto* text = std::get_if<std::string>(&value);
  if (!text) return store_in(slot.coefficient, value, range);
  if (*text != "unbounded") return "(must be a number >= 0 or \"unbounded\")";
  slot.coefficient = std::numeric_limits<double>::infinity();
  return std::nullopt;
}

/// The array that the value is, or that the single number which it is stands for.
std::optional<Array> array_in(const Value& value) {
  if (const auto* array = std::get_if<Array>(&value)) return *array;
  if (const auto* real = std::get_if<double>(&value)) return Array{{*real}};
  if (const auto* integer = std::get_if<std::int64_t>(&value)) {
    return Array{{static_cast<double>(*integer)}};
  }
  return std::nullopt;
}

Objection store_in(std::vector<double>& slot, const Value& value, const Range& range) {
  constexpr std::string_view needed = "an array of numbers";
  const auto array = array_in(value);
  if (!array || array->items.empty()) return wrong_kind(value, needed);
  std::vector<double> numbers;
  for (const Array::Item& item : array->items) {
    const auto* number = std::get_if<double>(&item);
    if (!number) return fmt::format("(found more than numbers in it, needs {})", needed);
    if (const auto wrong = wrong_number(*number, range)) {
      return fmt::format("({} in it {})", *number, *wrong);
    }
    numbers.push_back(*number);
  }
  slot = std::move(numbers);
  return std::nullopt;
}

/// The components of one sphere, or why there are none.
Objection store_sphere(std::vector<double>& row, const Array::Item& item) {
  if (const auto* text = std::get_if<std::string>(&item)) {
    return fmt::format("found {}, needs an array of numbers", *text);
  }
  const auto* number = std::get_if<double>(&item);
  row = number ? std::vector{*number} : std::get<std::vector<double>>(item);
  for (const double component : row) {
    if (!std::isfinite(component)) {
      return fmt::format("found {}, every component must be a finite number", component);
    }
  }
  return std::nullopt;
}

Objection store_in(std::vector<std::vector<double>>& slot, const Value& value, const Range&) {
  const auto* array = std::get_if<Array>(&value);
  if (!array || array->items.empty()) {
    return wrong_kind(value, "an array with an array of numbers for each sphere");
  }
  if (array->items.size() > most_written_spheres) {
    return fmt::format(
        "(has {} spheres, at most {} can be written); use start.arrangement = "
        "\"file\"",
        array->items.size(), most_written_spheres);
  }
  std::vector<std::vector<double>> rows(array->items.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (const auto wrong = store_sphere(rows[i], array->items[i])) {
      return fmt::format("(sphere {}: {})", i, *wrong);
    }
  }
  slot = std::move(rows);
  return std::nullopt;
}

template <class Integer>
requires(std::is_integral_v<Integer> && !std::is_same_v<Integer, bool>) Objection
    store_in(Integer& slot, const Value& value, const Range& range) {
  std::int64_t number = 0;
  if (const auto* integer = std::get_if<std::int64_t>(&value)) {
    number = *integer;
  } else if (const auto* real = std::get_if<double>(&value)) {
    if (!std::isfinite(*real)) return "(must be a finite number)";
    if (*real != std::trunc(*real)) return "(found a number with a fraction, needs an integer)";
    if (!range.contains(*real)) return fmt::format("({})", range_text(range));
    if (std::abs(*real) >= 0x1p63) return "(must fit in 64 bits: at most 9223372036854775807)";
    number = static_cast<std::int64_t>(*real);
  } else {
    return wrong_kind(value, "an integer");
  }
  if (!range.contains(static_cast<double>(number))) return fmt::format("({})", range_text(range));
  slot = static_cast<Integer>(number);
  return std::nullopt;
}

template <class Held>
Objection store_in(std::optional<Held>& slot, const Value& value, const Range& range) {
  Held held{};
  Objection objection = store_in(held, value, range);
  if (!objection) slot = held;
  return objection;
}

}  // namespace

std::optional<std::string> store(Slot slot, const Range& range, const Value& value) {
  return std::visit([&](auto* held) { return store_in(*held, value, range); }, slot);
}

}  // namespace zenosphere::case_format
