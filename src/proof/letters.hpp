#pragma once

#include <optional>
#include <span>
#include <vector>

namespace zenosphere {

/// The shortest round of two letters or more with which a history of contacts ends three times in a
/// row. Nothing if there is none.
std::optional<std::vector<int>> round_at_end(std::span<const int> history);

/// The letters of a history that hang together with its last one, letter beside letter, ascending;
/// on a periodic line of `period` letters (0: an infinite line) from the first one after a letter
/// that is missing. Empty if none is missing there.
std::vector<int> letters_around_last(std::span<const int> history, int period);

}  // namespace zenosphere
