#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/huge_page_vector.hpp"
#include "engine/prefetching.hpp"
#include "engine/simd/members_in_rows.hpp"

namespace zenosphere {

/// Which spheres are in which cell. Cells are so narrow that few hold more than two: these have
/// places, and the second one leads to any others.
class CellMembers {
 public:
  CellMembers(std::int32_t cells, std::int32_t spheres);

  void insert(std::int32_t sphere, std::int32_t cell);
  void remove(std::int32_t sphere, std::int32_t cell);

  /// Lets the cell `behind` another one stand for what is in that now, one period along x further
  /// on; 0: none does.
  void repeat(std::int32_t cell, std::int32_t behind);

  /// Writes the spheres in these cells to `found`.
  ///
  /// \param found  with room for most() of each cell and `slack` more
  /// \return       the end of what has been written
  Neighbour* find(ScatteredCells& cells, Neighbour* found) const {
    return find_members({places_.data(), next_.data()}, cells, found);
  }
  Neighbour* find(const CellBlock& cells, Neighbour* found) const {
    return find_members({places_.data(), next_.data()}, cells, found);
  }

  /// No cell has had more spheres.
  std::size_t most() const { return most_; }

  /// So many Neighbours behind those that are found may be overwritten.
  static constexpr std::size_t slack = 8;

  void prefetch(SeenCell cell) const { prefetch_line(&places_[2 * std::size_t{cell.cell()}]); }

 private:
  static constexpr std::int32_t none = -1;

  std::uint32_t* places(std::int32_t cell) { return &places_[2 * static_cast<std::size_t>(cell)]; }
  std::int32_t& next(std::int32_t sphere) { return next_[static_cast<std::size_t>(sphere)]; }
  std::uint32_t place_for(std::int32_t sphere) const;

  HugePageVector<std::uint32_t> places_;  ///< two of each cell, see CellPlace
  HugePageVector<std::int32_t> next_;     ///< after a sphere that leads to another one
  std::size_t most_ = 2;
};

}  // namespace zenosphere
