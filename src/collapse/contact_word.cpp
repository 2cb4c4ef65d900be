#include "collapse/contact_word.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "collapse/contact_graph.hpp"

namespace zenosphere {
namespace {

using Contact = std::pair<std::int32_t, std::int32_t>;

constexpr std::size_t longest_period = 128;
constexpr std::size_t least_repeats = 4;
constexpr std::size_t looked_at = longest_period * least_repeats;

char letter(std::size_t place) {
  if (place < 26) return static_cast<char>('a' + place);
  return place < 52 ? static_cast<char>('A' + (place - 26)) : '?';
}

/// The letter of each pair that occurs.
std::map<Contact, char> letters_of(std::span<const Contact> contacts) {
  ContactGraph graph;
  std::set<Contact> pairs;
  for (const Contact& contact : contacts) {
    if (pairs.insert(contact).second) graph.connect(contact.first, contact.second);
  }
  std::map<Contact, char> letters;
  const auto row = graph.longest_way(contacts.front().first);
  for (std::size_t k = 0; k + 1 < row.size(); ++k) {
    letters.emplace(std::minmax(row[k], row[k + 1]), letter(k));
  }
  for (const Contact& pair : pairs) letters.try_emplace(pair, letter(letters.size()));
  return letters;
}

bool repeats_at_end(const std::string& text, std::size_t period) {
  if (text.size() < least_repeats * period) return false;
  const std::size_t begin = text.size() - least_repeats * period;
  for (std::size_t k = begin; k + period < text.size(); ++k) {
    if (text[k] != text[k + period]) return false;
  }
  return true;
}

std::string first_rotation(const std::string& period) {
  std::string first = period;
  for (std::size_t shift = 1; shift < period.size(); ++shift) {
    first = std::min(first, period.substr(shift) + period.substr(0, shift));
  }
  return first;
}

}  // namespace

ContactWord contact_word(std::span<const Contact> contacts) {
  if (contacts.empty()) return {};
  const auto tail = contacts.last(std::min(contacts.size(), looked_at));
  const auto letters = letters_of(tail);
  std::string text;
  for (const Contact& contact : tail) text += letters.at(contact);
  for (std::size_t period = 1; period <= longest_period; ++period) {
    if (!repeats_at_end(text, period)) continue;
    return {first_rotation(text.substr(text.size() - period)), true};
  }
  const std::size_t round = std::min(text.size(), 2 * letters.size());
  return {text.substr(text.size() - round), false};
}

}  // namespace zenosphere
