#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace zenosphere {

/// The order in which the pairs of a cluster meet, one letter for each collision.
struct ContactWord {
  std::string letters;       ///< one period, or the last round where there is none
  bool is_periodic = false;  ///< the period was seen four times in a row at the end
};

/// The word at the end of a sequence of contacts.
///
/// Letters are a, b, c, ... along the row of spheres where the contacts form one, from the end with
/// the lower number; otherwise in the order of the pairs. After z come A to Z, then (52), (53), ...
/// Of the rotations of a period the alphabetically first is given: ababcb.
///
/// Source: words of contacts as in Dolmaire & Huebner-Rosenau, arXiv 2411.10324.
///
/// \param contacts  in order; i < j
ContactWord contact_word(std::span<const std::pair<std::int32_t, std::int32_t>> contacts);

}  // namespace zenosphere
