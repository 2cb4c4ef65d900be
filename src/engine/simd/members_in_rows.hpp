#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/neighbour_lists.hpp"
#include "engine/periodic_image.hpp"

namespace zenosphere {

/// A place for a sphere in a cell: which one it is, if any. In a row's first cells, which stand
/// once more behind its end, it is seen there one period further along x.
struct CellPlace {
  static constexpr std::uint32_t taken = std::uint32_t{1} << 31;
  static constexpr std::uint32_t more = std::uint32_t{1} << 30;  ///< others follow this sphere
  static constexpr std::uint32_t seen = more - 1;                ///< it, as a Neighbour
};

/// A cell, and the periodic image in which it is seen: sums, of which each axis has a part.
struct SeenCell {
  std::uint64_t sum;  ///< the number of the cell; in the upper half the image, as Neighbour has it

  std::uint32_t cell() const { return static_cast<std::uint32_t>(sum); }
  std::uint32_t image() const { return static_cast<std::uint32_t>(sum >> 32); }
  friend SeenCell operator+(SeenCell a, SeenCell b) { return {a.sum + b.sum}; }
};

/// The places of the first so many of four cells, as a set of bits.
inline std::uint32_t places_of(std::size_t cells) { return (std::uint32_t{1} << (2 * cells)) - 1; }

/// Up to four cells one after the other.
struct CellRun {
  SeenCell first;
  std::uint32_t places;  ///< which of eight are theirs, as a set of bits

  CellRun() = default;
  CellRun(SeenCell first_cell, int cells)
      : first(first_cell), places(places_of(static_cast<std::size_t>(cells))) {}
};

/// Cells side by side: a run or more of each of some layers, in the same rows of each.
struct CellBlock {
  static constexpr std::size_t most_runs = 6;
  static constexpr std::size_t most_rows = 3;

  std::array<CellRun, most_runs> runs;  ///< in the row at z = 0
  std::size_t run_count = 0;
  std::array<SeenCell, most_rows> rows;  ///< their parts
  std::size_t row_count = 0;             ///< one, or all

  void add(const CellRun& run) { runs[run_count++] = run; }
  void add_row(SeenCell row) { rows[row_count++] = row; }
};

/// Cells apart from each other.
struct ScatteredCells {
  static constexpr std::size_t most = 12;  ///< a multiple of four
  std::array<SeenCell, most> cells;
  std::size_t count = 0;

  void add(SeenCell cell) { cells[count++] = cell; }
};

/// Spheres in cells.
struct MembersOfCells {
  const std::uint32_t* places;  ///< two CellPlaces for each cell; six may be read behind the last
  const std::int32_t* next;     ///< after each sphere, in the same cell; -1: none
};

/// Writes the spheres in these cells: those that have places, then the others there. Those of four
/// cells at once where has_wide_lanes(), else one after the other.
///
/// \param found  with room for all, and for eight more
/// \return       the end of what has been written
Neighbour* find_members(const MembersOfCells& members, const CellBlock& cells, Neighbour* found);
Neighbour* find_members(const MembersOfCells& members, ScatteredCells& cells, Neighbour* found);

}  // namespace zenosphere
