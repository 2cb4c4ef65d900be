#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace zenosphere {

/// The letters of the shortest round with which a history of contacts ends three times in a row.
/// Nothing if there is none.
std::optional<std::vector<int>> repeating_word(std::span<const int> history);

/// A round as text, of all its rotations the first in the alphabet: "abcb". Letter 0 is a; from the
/// 27th on letters are written (26), (27), ...
std::string word_text(const std::vector<int>& word);

/// The letters of a history that hang together with its last one, letter beside letter, ascending;
/// on a periodic line of `period` letters (0: an infinite line) from the first one after a letter
/// that is missing. Empty if none is missing there.
std::vector<int> letters_around_last(std::span<const int> history, int period);

}  // namespace zenosphere
