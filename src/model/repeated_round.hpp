#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace zenosphere {

/// The letters of the shortest round with which a history of contacts ends several times in a row.
/// Nothing if there is none.
///
/// \param times     that it must be seen
/// \param shortest  round that is looked for, letters; and the longest
std::optional<std::vector<int>> repeated_round(std::span<const int> history, std::size_t times,
                                               std::size_t shortest, std::size_t longest);

/// Letters as text: a to z, A to Z, then (52), (53), ...
std::string text_of_letters(std::span<const int> letters);

/// The rotation of a round that is the first in the order of its letters: "abcb" for "bcba".
std::vector<int> first_rotation(const std::vector<int>& round);

}  // namespace zenosphere
