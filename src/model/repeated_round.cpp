#include "model/repeated_round.hpp"

#include <algorithm>

namespace zenosphere {

std::optional<std::vector<int>> repeated_round(std::span<const int> history, std::size_t times,
                                               std::size_t shortest, std::size_t longest) {
  for (std::size_t period = shortest; period <= longest; ++period) {
    if (history.size() < times * period) return std::nullopt;
    const auto tail = history.last(times * period);
    if (!std::equal(tail.begin() + static_cast<std::ptrdiff_t>(period), tail.end(), tail.begin())) {
      continue;
    }
    const auto round = history.last(period);
    return std::vector<int>(round.begin(), round.end());
  }
  return std::nullopt;
}

std::string text_of_letters(std::span<const int> letters) {
  std::string text;
  for (const int letter : letters) {
    if (letter < 26) {
      text += static_cast<char>('a' + letter);
    } else if (letter < 52) {
      text += static_cast<char>('A' + (letter - 26));
    } else {
      text.append("(").append(std::to_string(letter)).append(")");
    }
  }
  return text;
}

std::vector<int> first_rotation(const std::vector<int>& round) {
  std::vector<int> first = round;
  std::vector<int> rotated = round;
  for (std::size_t k = 1; k < round.size(); ++k) {
    std::rotate(rotated.begin(), rotated.begin() + 1, rotated.end());
    first = std::min(first, rotated);
  }
  return first;
}

}  // namespace zenosphere
