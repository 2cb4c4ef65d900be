#include "cli/shipped_cases.hpp"

namespace zenosphere {

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
    if (ends && title[n + 1] == ' ') return title.substr(0, n + (title[n] == '?' ? 1 : 0));
  }
  return title;
}

}  // namespace zenosphere
