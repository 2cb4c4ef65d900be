#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/huge_page_vector.hpp"
#include "engine/neighbour_lists.hpp"
#include "engine/periodic_image.hpp"
#include "engine/prefetching.hpp"
#include "engine/reference_position.hpp"

namespace zenosphere {

/// The reference positions of the spheres, cell by cell, side by side as a search for neighbours
/// reads them.
///
/// A reference position need not be just where the sphere was, only known exactly. Places are
/// counted in grains, of which the widest cell has `grains_a_cell` in a row: integers of 16 bits,
/// whatever the size of the box.
class ReferenceCells {
 public:
  /// Five cells of them are within 16 bits, and so far from the end that free places are out of
  /// reach.
  static constexpr int grains_a_cell = 6000;

  /// Cells that follow one another along x, and the place around which reference positions are
  /// looked for there: it may slide along x.
  struct Row {
    std::int32_t first, last;        ///< cells
    PeriodicImage periodic_image;    ///< in which they are seen
    ReferencePosition::Place place;  ///< from the lower corner of the first cell, grains
    std::int16_t slide;              ///< how far either way, grains
  };
  /// What is near.
  struct Range {
    std::int32_t square;      ///< of the distance, grains^2
    std::int16_t cell_width;  ///< along x, grains
  };

  /// What is near, where spheres differ in size. Each has a code of its size in its label.
  struct SizedRange {
    int reach;                ///< distance of one whose code is 0, grains
    int shift;                ///< for each code it is 2^shift grains more
    std::int16_t cell_width;  ///< as above
  };

  explicit ReferenceCells(std::int32_t cells);

  /// \param label  number of the sphere; beyond Neighbour::sphere_bits a code of its size, below
  /// 128
  void insert(std::int32_t label, std::int32_t cell, const ReferencePosition& reference);
  void remove(std::int32_t label, std::int32_t cell);

  /// Writes the neighbours in rows of cells to `found`.
  ///
  /// \param found  with room for room() of each cell and `slack` more
  /// \return       the end of what has been written
  Neighbour* find(std::span<const Row> rows, const Range& range, Neighbour* found) const;
  Neighbour* find(std::span<const Row> rows, const SizedRange& range, Neighbour* found) const;

  /// No cell has had more spheres, or few more.
  std::size_t room() const { return longest_ * Chunk::places; }

  /// Prefetches the cells `first` to `last`.
  void prefetch(std::int32_t first, std::int32_t last) const {
    for (std::int32_t cell = first; cell <= last; ++cell) prefetch_line(&chunk(cell));
  }

  /// So many Neighbours behind those that are found may be overwritten.
  static constexpr std::size_t slack = 8;

  /// Places for six spheres, as many as a line of the cache holds; at free ones, which come last,
  /// the reference position is far from everywhere.
  struct alignas(64) Chunk {
    static constexpr std::size_t places = 6;
    static constexpr std::int32_t none = -1;
    std::int16_t xy[places][2];
    std::int32_t label[places];
    std::int16_t z[places];
    std::int32_t next = none;  ///< further spheres of the cell
  };
  static_assert(sizeof(Chunk) == 64);

 private:
  Chunk& append_to(Chunk& last);
  const Chunk& chunk(std::int32_t cell) const { return chunks_[static_cast<std::size_t>(cell)]; }
  Chunk& chunk(std::int32_t cell) { return chunks_[static_cast<std::size_t>(cell)]; }

  HugePageVector<Chunk> chunks_;      ///< the first of each cell
  std::vector<Chunk> further_;        ///< of cells in which spheres crowd together
  std::vector<std::int32_t> unused_;  ///< of the further ones
  std::size_t longest_ = 1;
};

}  // namespace zenosphere
