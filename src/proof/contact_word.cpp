#include "proof/contact_word.hpp"

#include <algorithm>
#include <set>

namespace zenosphere {

namespace {

bool ends_with_period(std::span<const int> history, std::size_t period) {
  constexpr std::size_t kRounds = 3;
  if (history.size() < kRounds * period) return false;
  const auto tail = history.last(kRounds * period);
  return std::equal(tail.begin() + static_cast<std::ptrdiff_t>(period), tail.end(), tail.begin());
}

}  // namespace

std::optional<std::vector<int>> repeating_word(std::span<const int> history) {
  for (std::size_t period = 2; 3 * period <= history.size(); ++period) {
    if (!ends_with_period(history, period)) continue;
    const auto round = history.last(period);
    return std::vector<int>(round.begin(), round.end());
  }
  return std::nullopt;
}

std::string word_text(const std::vector<int>& word) {
  std::vector<int> first = word;
  std::vector<int> rotated = word;
  for (std::size_t k = 1; k < word.size(); ++k) {
    std::rotate(rotated.begin(), rotated.begin() + 1, rotated.end());
    first = std::min(first, rotated);
  }
  std::string text;
  for (const int letter : first) {
    if (letter < 26) {
      text += static_cast<char>('a' + letter);
    } else {
      text.append("(").append(std::to_string(letter)).append(")");
    }
  }
  return text;
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
