#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/cell_members.hpp"
#include "engine/cell_rows.hpp"
#include "engine/sliding_cells.hpp"

namespace zenosphere {

/// The search for neighbours among cells alone, without lists: in dilute systems.
///
/// A sphere sees all in its own cell and those around, and while it crosses no face that stays so:
/// when it crosses one, those are new to it that are in cells which it has not seen before. Layers
/// that slide are seen as far as they come near within one clock unit; then they have slid by a
/// cell, and each sphere sees one column more of the layer above. So of two spheres that come near
/// each other always one is told.
///
/// The box has at least seven cells along x and four along other axes, so that no sphere is seen
/// in two images. Spans that are returned hold until the next call; up to three neighbours more may
/// be read behind their ends.
template <int Dim>
class CellSearch {
 public:
  using Reach = typename SlidingCells<Dim>::Reach;

  /// What moves the columns of adjacent layers by parts of a cell.
  struct Slides {
    bool layers = false;  ///< they slide
    bool images = false;  ///< beyond the faces along y, which are displaced
  };

  /// \param cells  number of cells along each axis
  CellSearch(const Steps<Dim>& cells, std::int32_t spheres, Slides slides)
      : rows_(cells), members_(rows_.count(), spheres), slides_(slides) {}

  static bool has_room_in(const Steps<Dim>& cells);
  void displace_images() { slides_.images = true; }
  bool has_slides() const { return slides_.layers || slides_.images; }

  void insert(std::int32_t sphere, const Steps<Dim>& cell);
  void remove(std::int32_t sphere, const Steps<Dim>& cell);

  /// All in the cell at `home` and around it: a sphere there is among its own neighbours. It never
  /// approaches itself.
  std::span<const Neighbour> around(const SlidingCells<Dim>& cells, const Steps<Dim>& home) const;

  /// A step from one cell to another.
  struct Crossing {
    int axis;
    int direction;  ///< -1 or +1
    Steps<Dim> from;
    Steps<Dim> to;
  };
  /// Those that a sphere which has crossed a face has not seen before.
  std::span<const Neighbour> beyond(const SlidingCells<Dim>& cells, const Crossing& crossing) const;

  /// Those that spheres at `home` have not seen before the layers had slid by one more cell: of
  /// each pair one sees the other here.
  std::span<const Neighbour> slid_near(const SlidingCells<Dim>& cells,
                                       const Steps<Dim>& home) const;

  /// The image in which one cell sees another, where they are near enough for spheres in them to
  /// touch.
  std::optional<PeriodicImage> periodic_image(const SlidingCells<Dim>& cells,
                                              const Steps<Dim>& from, const Steps<Dim>& to) const;

  /// The columns of the layers below, beside and above in which a sphere sees others.
  Reach reach(const SlidingCells<Dim>& cells, const Steps<Dim>& home) const;

  /// Prefetches the cells around one.
  void prefetch(const SlidingCells<Dim>& cells, const Steps<Dim>& home) const;

 private:
  CellBlock block_around(const SlidingCells<Dim>& cells, const Steps<Dim>& home) const;
  void add_columns_behind(const SlidingCells<Dim>& cells, const Crossing& crossing,
                          const Reach& reach, CellBlock& block) const;
  /// \param cells  a CellBlock, or ScatteredCells
  template <class Cells>
  std::span<const Neighbour> members_of(Cells&& cells) const;

  void repeat(const Steps<Dim>& cell);

  CellRows<Dim> rows_;
  CellMembers members_;
  Slides slides_;
  mutable std::vector<Neighbour> nearby_;  ///< scratch
};

}  // namespace zenosphere
