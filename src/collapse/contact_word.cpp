#include "collapse/contact_word.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "collapse/contact_graph.hpp"
#include "model/repeated_round.hpp"

namespace zenosphere {
namespace {

using SpherePair = std::pair<std::int32_t, std::int32_t>;

constexpr std::size_t longest_period = 128;
constexpr std::size_t least_rounds = 4;
constexpr std::size_t looked_at = longest_period * least_rounds;

/// The letter of each pair that occurs.
std::map<SpherePair, int> letters_of(std::span<const SpherePair> contacts) {
  ContactGraph graph;
  std::set<SpherePair> pairs;
  for (const SpherePair& contact : contacts) {
    if (pairs.insert(contact).second) graph.connect(contact.first, contact.second);
  }
  std::map<SpherePair, int> letters;
  const auto row = graph.longest_way(contacts.front().first);
  for (std::size_t k = 0; k + 1 < row.size(); ++k) {
    letters.emplace(std::minmax(row[k], row[k + 1]), static_cast<int>(k));
  }
  for (const SpherePair& pair : pairs) letters.try_emplace(pair, static_cast<int>(letters.size()));
  return letters;
}

}  // namespace

ContactWord contact_word(std::span<const SpherePair> contacts) {
  if (contacts.empty()) return {};
  const auto tail = contacts.last(std::min(contacts.size(), looked_at));
  const auto letters = letters_of(tail);
  std::vector<int> history;
  for (const SpherePair& contact : tail) history.push_back(letters.at(contact));
  const auto round = repeated_round(history, least_rounds, 1, longest_period);
  if (round) return {text_of_letters(first_rotation(*round)), true};
  const std::size_t shown = std::min(history.size(), 2 * letters.size());
  return {text_of_letters(std::span(history).last(shown)), false};
}

}  // namespace zenosphere
