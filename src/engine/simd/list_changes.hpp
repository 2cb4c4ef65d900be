#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/neighbour_lists.hpp"
#include "engine/simd/equal_in_four.hpp"

namespace zenosphere {

/// Of lists longer than this the rest is dealt with one by one.
inline constexpr std::size_t most_in_a_set = NeighbourLists::most_places;

/// A set of as many bits as there are neighbours that a set can tell apart.
inline std::uint64_t all_of(std::size_t count) {
  return count < most_in_a_set ? (std::uint64_t{1} << count) - 1 : ~std::uint64_t{0};
}

/// Where `wanted` stands among `count` entries, of which only the bits in `mask` count: a set of
/// bits. Entries are compared four at a time, up to three behind the last.
inline std::uint64_t places_of(const Neighbour* entries, std::size_t count, std::uint32_t wanted,
                               std::uint32_t mask) {
  std::uint64_t places = 0;
  count = std::min(count, most_in_a_set);
  for (std::size_t k = 0; k < count; k += 4) {
    places |= std::uint64_t{equal_in_four(entries + k, wanted, mask)} << k;
  }
  return places & all_of(count);
}

/// What NeighbourLists::changes() tells of a list: all at once in registers where has_wide_lanes()
/// and they have room for it, else one by one.
NeighbourLists::Changes list_changes(std::span<const Neighbour> before, std::span<Neighbour> now);

}  // namespace zenosphere
