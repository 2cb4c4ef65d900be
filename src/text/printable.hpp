#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace zenosphere {

/// A text for a terminal: control characters other than line ends and tabs become `?`.
///
/// What a file of unknown origin says is shown to people; it must not move their cursor, change
/// the title of their window or answer for them.
inline std::string printable(std::string_view text) {
  std::string result(text);
  for (std::size_t n = 0; n < result.size(); ++n) {
    const auto byte = static_cast<unsigned char>(result[n]);
    const bool is_control = (byte < 0x20 && byte != '\n' && byte != '\t') || byte == 0x7F;
    const bool follows_c2 = n > 0 && static_cast<unsigned char>(text[n - 1]) == 0xC2;
    const bool is_c1 = follows_c2 && byte >= 0x80 && byte < 0xA0;  // U+0080 to U+009F in UTF-8
    if (is_control || is_c1) result[n] = '?';
    if (is_c1) result[n - 1] = '?';
  }
  return result;
}

inline constexpr std::size_t longest_shown = 60;  ///< of the user's text in a message [bytes]

/// A piece of the user's text as messages repeat it: cut where it would not fit on a line.
inline std::string shortened(std::string_view text) {
  if (text.size() <= longest_shown) return std::string(text);
  std::size_t end = longest_shown;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // whole UTF-8
  return std::string(text.substr(0, end)) + "...";
}

/// Whether a text is one line of printable ASCII, as the program's own are: fit for JSON too.
inline bool is_plain(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

}  // namespace zenosphere
