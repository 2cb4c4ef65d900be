// What a case holds, as TOML writes it.

#include <fmt/format.h>

#include <cmath>
#include <type_traits>

#include "case/case_choices.hpp"
#include "case/case_table.hpp"
#include "case/case_words.hpp"

namespace zenosphere::case_format {
namespace {

std::optional<std::string> text_of(const std::vector<double>& numbers) {
  if (numbers.empty()) return std::nullopt;
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ", ") + real_text(number);
  return '[' + text + ']';
}

std::optional<std::string> text_of(const std::vector<std::vector<double>>& rows) {
  if (rows.empty()) return std::nullopt;
  std::string text = "[\n";
  for (const auto& row : rows) text += fmt::format("  {},\n", text_of(row).value_or("[]"));
  return text + ']';
}

/// What is too small for a TOML reader's `double` stands in quotes.
std::optional<std::string> text_of(const GapThreshold& threshold) {
  return threshold.fits_double() ? real_text(threshold.nearest_double())
                                 : in_quotes(threshold.text());
}

std::optional<std::string> text_of(const Friction& friction) {
  return std::isinf(friction.coefficient) ? in_quotes("unbounded")
                                          : real_text(friction.coefficient);
}

std::optional<std::string> text_of(const AverageStart& start) {
  return start.is_found() ? in_quotes("auto") : real_text(start.time());
}

template <class Held>
std::optional<std::string> text_of(const Held& held) {
  if constexpr (std::is_same_v<Held, Precision>) return in_quotes(held.word());
  if constexpr (std::is_same_v<Held, std::string>) {
    return held.empty() ? std::nullopt : std::optional(in_quotes(held));
  }
  if constexpr (std::is_same_v<Held, double>) return real_text(held);
  if constexpr (std::is_arithmetic_v<Held>) return fmt::format("{}", held);
  if constexpr (std::is_enum_v<Held>) {
    for (const auto& word : words_of(held)) {
      if (word.choice == held) return in_quotes(word.text);
    }
  }
  return std::nullopt;
}

template <class Held>
std::optional<std::string> text_of(const std::optional<Held>& held) {
  return held ? text_of(*held) : std::nullopt;
}

}  // namespace

std::optional<std::string> toml_text(Slot slot) {
  return std::visit([](const auto* held) { return text_of(*held); }, slot);
}

std::optional<std::string> toml_text(const Key& key, Case& values) {
  if (!key.exists_in(values)) return std::nullopt;
  return toml_text(key.slot(values));
}

}  // namespace zenosphere::case_format

namespace zenosphere {

std::string word(Precision precision) { return precision.word(); }
const char* word(OverlapRule rule) { return case_format::word_for(rule); }

}  // namespace zenosphere
