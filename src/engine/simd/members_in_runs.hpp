#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/neighbour_lists.hpp"
#include "engine/periodic_image.hpp"

namespace zenosphere {

/// A place for a sphere in a cell: which one it is, if any. In a row's first cells, which stand
/// once more behind its end, it is seen there one period further along x.
struct CellPlace {
  static constexpr std::uint32_t empty = std::uint32_t{1} << 31;
  static constexpr std::uint32_t more = std::uint32_t{1} << 30;  ///< others follow this sphere
  static constexpr std::uint32_t seen = more - 1;                ///< it, as a Neighbour
};

/// Of eight places those that are not of the first so many cells, as a set of bits.
inline std::uint32_t places_beyond(std::size_t cells) {
  return 0xFFU & static_cast<std::uint32_t>(std::uint64_t{0xFF} << (2 * cells));
}

/// Up to four cells one after the other, and the periodic image in which they are seen.
struct CellRun {
  /// The number of the first, and in the upper half the image, as a Neighbour without a number: so
  /// parts of both are added up at once.
  std::uint64_t place;
  std::uint32_t left_out;  ///< which of eight places count for nothing, as a set of bits

  static CellRun of(std::uint64_t place, int cells) {
    return {place, places_beyond(static_cast<std::size_t>(cells))};
  }
  /// The same cells of a row whose place differs by so much.
  CellRun beyond(std::uint64_t step) const { return {place + step, left_out}; }
  std::uint32_t first() const { return static_cast<std::uint32_t>(place); }
  std::uint32_t seen() const { return static_cast<std::uint32_t>(place >> 32); }
};

/// The places of cells that do not stand one after the other, as those of CellRun.
struct ScatteredCells {
  static constexpr std::size_t most = 12;  ///< a multiple of four
  std::array<std::uint64_t, most> places;
  std::size_t count = 0;

  void add(std::uint64_t place) { places[count++] = place; }
};

/// Spheres in cells.
struct MembersOfCells {
  const std::uint32_t* places;  ///< two CellPlaces for each cell; six may be read behind the last
  const std::int32_t* next;     ///< after each sphere, in the same cell; -1: none
};

/// Writes the spheres in these cells: those of a run that have places, then the others there. A run
/// at once where has_wide_lanes(), else one after the other.
///
/// \param found  with room for all, and for eight more
/// \return       the end of what has been written
Neighbour* find_members(const MembersOfCells& members, std::span<const CellRun> runs,
                        Neighbour* found);

/// The same of cells apart from each other, four of them at once.
Neighbour* find_members(const MembersOfCells& members, ScatteredCells& cells, Neighbour* found);

}  // namespace zenosphere
