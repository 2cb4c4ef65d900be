#include "cli/shipped_cases.hpp"

namespace zenosphere {

namespace {

/// Whether what ends at `end` is cut short there, as Phys. and Rev. are: no sentence ends in a word
/// that begins with a capital.
bool is_abbreviation(const std::string& text, std::size_t end) {
  if (text[end] != '.') return false;
  const std::size_t blank = text.find_last_of(' ', end);
  const std::size_t begin = blank == std::string::npos ? 0 : blank + 1;
  return text[begin] >= 'A' && text[begin] <= 'Z';
}

}  // namespace

std::string title_of(const ShippedCase& shipped) {
  std::string title;
  std::string_view rest = shipped.text;
  while (rest.starts_with("# ")) {
    const std::string_view line = rest.substr(2, rest.find('\n') - 2);
    title += (title.empty() ? "" : " ") + std::string(line);
    rest.remove_prefix(rest.find('\n') + 1);
  }
  for (std::size_t n = 0; n + 1 < title.size(); ++n) {
    const bool ends = title[n] == '.' || title[n] == '?' || title[n] == ':';
    if (!ends || title[n + 1] != ' ' || is_abbreviation(title, n)) continue;
    return title.substr(0, n + (title[n] == '?' ? 1 : 0));
  }
  return title;
}

}  // namespace zenosphere
