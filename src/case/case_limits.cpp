#include "case/case_limits.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace zenosphere::case_format {
namespace {

std::optional<Excess> line_too_long(std::string_view text) {
  std::int64_t number = 1;
  for (std::size_t begin = 0; begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (end - begin > longest_line) {
      return Excess{number, fmt::format("line of more than {} bytes; break it", longest_line)};
    }
    begin = end + 1;
  }
  return std::nullopt;
}

/// Walks through a TOML text, over its strings and comments, and measures how deep it goes.
class Walk {
 public:
  explicit Walk(std::string_view text) : text_(text) {}

  std::optional<Excess> first_excess() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"' || c == '\'') {
        at_ = end_of_string(text_, at_);
      } else if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else {
        measure(c);
        ++at_;
      }
      if (dots_ >= most_key_parts) {
        return excess(fmt::format("key of more than {} parts; shorten it", most_key_parts));
      }
      if (depth_ > deepest_nesting) {
        return excess(fmt::format("more than {} brackets within each other", deepest_nesting));
      }
    }
    return std::nullopt;
  }

 private:
  Excess excess(std::string what) const {
    const auto newlines = std::count(text_.begin(), text_.begin() + static_cast<long>(at_), '\n');
    return {newlines + 1, std::move(what)};
  }

  void measure(char c) {
    if (c == '.') {
      ++dots_;
    } else if (c == '[' || c == '{') {
      ++depth_;
      dots_ = 0;
    } else if (c == ']' || c == '}') {
      depth_ = std::max(depth_ - 1, 0);
      dots_ = 0;
    } else if (c == ',' || c == '=' || c == '\n') {
      dots_ = 0;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  int dots_ = 0;  ///< since the last character that ends a key
};

}  // namespace

std::optional<Excess> excess_in(std::string_view text) {
  if (auto excess = line_too_long(text)) return excess;
  return Walk(text).first_excess();
}

std::size_t end_of_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const auto stands_here = [&](std::string_view mark) { return text.substr(at).starts_with(mark); };
  const std::string three(3, quote);
  const bool long_string = stands_here(three);
  const std::string_view end = long_string ? std::string_view(three) : text.substr(at, 1);
  at += end.size();
  while (at < text.size() && !stands_here(end) && (long_string || text[at] != '\n')) {
    at += quote == '"' && text[at] == '\\' ? 2 : 1;
  }
  if (at >= text.size()) return text.size();
  if (!stands_here(end)) return at;
  at += end.size();
  // The end of a long string may stand behind one or two quotes that belong to it.
  for (int extra = 0; long_string && extra < 2 && stands_here(end.substr(0, 1)); ++extra) ++at;
  return at;
}

}  // namespace zenosphere::case_format
