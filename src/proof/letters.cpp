#include "proof/letters.hpp"

#include <set>

#include "model/repeated_round.hpp"

namespace zenosphere {

std::optional<std::vector<int>> round_at_end(std::span<const int> history) {
  return repeated_round(history, 3, 2, history.size());
}

std::vector<int> letters_around_last(std::span<const int> history, int period) {
  const std::set<int> met(history.begin(), history.end());
  if (met.empty() || static_cast<int>(met.size()) == period) return {};
  const auto next = [period](int letter, int step) {
    return period > 0 ? (letter + step + period) % period : letter + step;
  };
  int letter = history.back();
  while (met.contains(next(letter, -1))) letter = next(letter, -1);
  std::vector<int> letters;
  for (; met.contains(letter); letter = next(letter, 1)) letters.push_back(letter);
  return letters;
}

}  // namespace zenosphere
