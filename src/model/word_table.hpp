#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <optional>
#include <string_view>

namespace zenosphere {

/// A word of files and of the screen, and what it stands for. A table of them is the one place
/// where a choice and its words stand.
template <class Choice>
struct Word {
  std::string_view text;  ///< a literal
  Choice choice;
};
template <class Choice>
Word(const char*, Choice) -> Word<Choice>;  // clang 14 does not deduce it for an aggregate

/// The word for a choice, which is in the table.
template <class Choice, std::size_t N>
const char* word_in(const std::array<Word<Choice>, N>& table, Choice choice) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [choice](const auto& word) { return word.choice == choice; });
  assert(found != table.end());
  return found->text.data();
}

/// What a word stands for; nothing where it is none of the table.
template <class Choice, std::size_t N>
std::optional<Choice> choice_in(const std::array<Word<Choice>, N>& table, std::string_view text) {
  for (const Word<Choice>& word : table) {
    if (word.text == text) return word.choice;
  }
  return std::nullopt;
}

}  // namespace zenosphere
