#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>

#include "io/case_table.hpp"
#include "io/spelling.hpp"

namespace zenosphere::case_format {
namespace {

template <class Choice>
struct Word {
  std::string_view text;
  Choice choice;
};
template <class Choice>
Word(const char*, Choice) -> Word<Choice>;  // clang 14 does not deduce it for an aggregate

constexpr std::array arrangement_words{Word{"fcc", Arrangement::fcc},
                                       Word{"random", Arrangement::random}};
constexpr std::array drive_words{Word{"none", DriveKind::none}, Word{"shear", DriveKind::shear}};
constexpr std::array overlap_words{
    Word{"rewind", OverlapRule::rewind}, Word{"immediate", OverlapRule::immediate},
    Word{"guarded", OverlapRule::guarded}, Word{"stop", OverlapRule::stop}};
constexpr std::array precision_words{Word{"double", Precision::double_precision}};
constexpr std::array log_words{Word{"all", CollisionLog::all}, Word{"window", CollisionLog::window},
                               Word{"none", CollisionLog::none}};

const auto& words_of(Arrangement) { return arrangement_words; }
const auto& words_of(DriveKind) { return drive_words; }
const auto& words_of(OverlapRule) { return overlap_words; }
const auto& words_of(Precision) { return precision_words; }
const auto& words_of(CollisionLog) { return log_words; }

/// Words that are reserved: they mean something that this version cannot do.
constexpr std::array<std::string_view, 3> later_precisions{"extended", "quad", "digits100"};
template <class Choice>
std::span<const std::string_view> later_words(Choice) {
  return {};
}
std::span<const std::string_view> later_words(Precision) { return later_precisions; }

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
    text += quoted(words[i].text);
  }
  return text;
}

template <class Choice>
Objection no_such_word(const std::string& text) {
  const std::string choices = choices_text<Choice>();
  for (const std::string_view later : later_words(Choice{})) {
    if (later == text) return fmt::format("(not in this version yet); use {}", choices);
  }
  std::vector<std::string_view> candidates;
  for (const auto& word : words_of(Choice{})) candidates.push_back(word.text);
  const auto meant = nearest(text, candidates);
  return fmt::format("(must be {})", choices) +
         (meant ? fmt::format("; did you mean {}?", quoted(*meant)) : "");
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

Objection store_in(bool& slot, const Value& value, const Range&) {
  const auto* boolean = std::get_if<bool>(&value);
  if (!boolean) return wrong_kind(value, "true or false");
  slot = *boolean;
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
  if (!std::isfinite(number)) return "(must be a finite number)";
  if (!range.contains(number)) return fmt::format("({})", range.text());
  slot = number;
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
    if (!range.contains(*real)) return fmt::format("({})", range.text());
    if (std::abs(*real) >= 0x1p63) return "(must fit in 64 bits: at most 9223372036854775807)";
    number = static_cast<std::int64_t>(*real);
  } else {
    return wrong_kind(value, "an integer");
  }
  if (!range.contains(static_cast<double>(number))) return fmt::format("({})", range.text());
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

template <class Held>
std::optional<std::string> text_of(const Held& held) {
  if constexpr (std::is_same_v<Held, double>) return real_text(held);
  if constexpr (std::is_arithmetic_v<Held>) return fmt::format("{}", held);
  if constexpr (std::is_enum_v<Held>) {
    for (const auto& word : words_of(held)) {
      if (word.choice == held) return quoted(word.text);
    }
  }
  return std::nullopt;
}

template <class Held>
std::optional<std::string> text_of(const std::optional<Held>& held) {
  return held ? text_of(*held) : std::nullopt;
}

}  // namespace

std::optional<std::string> store(const Key& key, const Value& value, Case& values) {
  const auto store_value = [&](auto* slot) { return store_in(*slot, value, key.range); };
  return std::visit(store_value, key.slot(values));
}

std::optional<std::string> toml_text(const Key& key, const Case& values) {
  if (!key.exists_in(values)) return std::nullopt;
  Case copy = values;  // slots point into a case that may be changed
  return std::visit([](const auto* slot) { return text_of(*slot); }, key.slot(copy));
}

}  // namespace zenosphere::case_format
