#include "cli/values.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "model/errors.hpp"
#include "text/spelling.hpp"

namespace zenosphere {

namespace {

/// The number that a word is as a whole, or nothing.
template <class Number>
std::optional<Number> number_in(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool is_whole = error == std::errc() && end == word.data() + word.size();
  return is_whole ? std::optional(number) : std::nullopt;
}

[[noreturn]] void reject(const std::string& option, const std::string& word,
                         const std::string& why) {
  throw InputError(fmt::format("{} = {} {}", option, word, why));
}

}  // namespace

CLI::Validator whole_number(const std::string& option, std::int64_t low, std::int64_t high) {
  return CLI::Validator(
      [=](const std::string& word) {
        const auto number = number_in<std::int64_t>(word);
        if (number && *number >= low && *number <= high) return std::string();
        reject(option, word, fmt::format("(must be a whole number in [{}, {}])", low, high));
      },
      "");
}

CLI::Validator positive_number(const std::string& option) {
  return CLI::Validator(
      [=](const std::string& word) {
        const auto number = number_in<double>(word);
        if (number && std::isfinite(*number) && *number > 0) return std::string();
        reject(option, word, "(must be a number > 0)");
      },
      "");
}

CLI::Validator one_of(const std::string& option, std::vector<std::string> words) {
  std::string name;  // by which completion and manual know the choices
  for (const std::string& word : words) name += (name.empty() ? "" : ",") + word;
  CLI::Validator validator(
      [option, words = std::move(words)](const std::string& word) {
        if (std::find(words.begin(), words.end(), word) != words.end()) return std::string();
        const std::vector<std::string_view> candidates(words.begin(), words.end());
        const auto meant = nearest(word, candidates);
        reject(option, word,
               fmt::format("(must be {}){}", alternatives(words),
                           meant ? fmt::format("; did you mean {}?", *meant) : ""));
      },
      "");
  return validator.name(name);
}

CLI::Validator such_as(const std::vector<std::string>& words) {
  std::string name;
  for (const std::string& word : words) name += word + ',';
  return CLI::Validator([](const std::string&) { return std::string(); }, "").name(name);
}

std::string alternatives(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t n = 0; n < words.size(); ++n) {
    if (n > 0) text += n + 1 == words.size() ? " or " : ", ";
    text += words[n];
  }
  return text;
}

}  // namespace zenosphere
