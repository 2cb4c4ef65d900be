#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace zenosphere::case_format {

/// Longest line of a case file [bytes].
inline constexpr std::size_t longest_line = 10'000;
/// Most parts of a dotted key, and brackets within brackets. A case needs two of each; toml++ frees
/// what it has read by recursion, so that some hundred thousand levels would exhaust the stack.
inline constexpr int most_key_parts = 16;
inline constexpr int deepest_nesting = 16;
/// Most keys and tables of a case file, and most overrides; all keys there are make 60.
inline constexpr std::size_t most_keys = 1000;

/// Something larger than a case may have it.
struct Excess {
  std::int64_t line;  ///< from 1
  std::string what;   ///< `line of more than 10000 bytes; break it`
};

/// The first excess of a TOML text, right or wrong, or nothing.
std::optional<Excess> excess_in(std::string_view text);

/// Where a string of TOML ends whose quote stands at a byte of the text: behind it, or at the end
/// of the line or text where it does not end.
std::size_t end_of_string(std::string_view text, std::size_t at);

}  // namespace zenosphere::case_format
