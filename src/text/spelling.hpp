#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace zenosphere {

/// Number of single letters to insert, delete or replace to turn one word into the other.
///
/// Source: Wagner & Fischer, J. ACM 21 (1974) 168.
std::size_t edit_distance(std::string_view one, std::string_view other);

/// The candidate that the user most likely meant by `word`, the first of equals, or nothing if
/// none is near: at most one edit for every three letters of the candidate, and at least one.
std::optional<std::string_view> nearest(std::string_view word,
                                        std::span<const std::string_view> candidates);

}  // namespace zenosphere
