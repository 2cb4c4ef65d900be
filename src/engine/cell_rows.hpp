#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/simd/members_in_rows.hpp"
#include "engine/sliding_cells.hpp"

namespace zenosphere {

/// Where the rows of cells beside a cell begin, and in which periodic image they are seen, from
/// tables: a sum of one entry for each axis.
///
/// Behind each row its first cells stand once more, so that what is seen of a row is never parted.
template <int Dim>
class CellRows {
 public:
  using Reach = typename SlidingCells<Dim>::Reach;
  using Columns = typename SlidingCells<Dim>::Columns;

  /// A run has so many cells at most.
  static constexpr int most_in_run = 4;
  /// So many of the first cells of a row stand once more behind its end.
  static constexpr int repeated = most_in_run - 1;

  /// \param cells  number of cells along each axis, along x more than `repeated`
  explicit CellRows(const Steps<Dim>& cells);

  /// Cells, those that stand once more counted too.
  std::int32_t count() const { return count_; }
  /// Cells along x: a cell that stands once more does so behind so many others.
  std::int32_t row_length() const { return cells_[0]; }
  /// The number of a cell.
  std::int32_t index(const Steps<Dim>& coordinates) const {
    std::int32_t cell = coordinates[0];
    for (std::size_t axis = 1; axis < Dim; ++axis) cell += coordinates[axis] * strides_[axis];
    return cell;
  }

  /// All cells around one, in a box without slides.
  CellBlock around(const Steps<Dim>& home) const {
    CellBlock block = all_rows(home);
    const SeenCell first_column = at(0, home[0] - 1);
    for (int layers = -aside_y; layers <= aside_y; ++layers) {
      block.add({first_column + layer(home, layers), 3});
    }
    return block;
  }
  /// Those of them that lie in one direction along y or z: done alike, since which of both it is,
  /// is as good as random.
  CellBlock beside(const Steps<Dim>& home, int axis, int direction) const {
    const auto along = static_cast<std::size_t>(axis);
    CellBlock block;
    for (int steps = -aside_z; steps <= aside_z; ++steps) {
      block.add_row(aside_z != 0 ? part(home, 3 - along, steps) : SeenCell{0});
    }
    block.add({at(0, home[0] - 1) + part(home, along, direction), 3});
    return block;
  }

  /// Those of them that lie in one direction along x.
  ScatteredCells column_beside(const Steps<Dim>& home, int direction) const {
    ScatteredCells scattered;
    const SeenCell column = at(0, home[0] + direction);
    for (int layers = -aside_y; layers <= aside_y; ++layers) {
      add_cells(home, column + layer(home, layers), scattered);
    }
    return scattered;
  }

  /// One cell of each row, with layers that slide.
  ///
  /// \param columns  of the layers below, beside and above, counted as those of a Reach
  ScatteredCells one_of_each_row(const SlidingCells<Dim>& cells, const Steps<Dim>& home,
                                 const std::array<int, 3>& columns) const {
    ScatteredCells scattered;
    for (int layers = -aside_y; layers <= aside_y; ++layers) {
      const int column = columns[static_cast<std::size_t>(layers + 1)];
      add_cells(home, run_in_layer(cells, home, layers, {column, column}).first, scattered);
    }
    return scattered;
  }

  /// All rows beside the cell at `home`, of no layer yet.
  CellBlock all_rows(const Steps<Dim>& home) const {
    CellBlock block;
    for (int row = -aside_z; row <= aside_z; ++row) block.add_row(across(home, row));
    return block;
  }
  /// One of them.
  CellBlock one_row(const Steps<Dim>& home, int row) const {
    CellBlock block;
    block.add_row(across(home, row));
    return block;
  }
  /// Adds some columns of a layer.
  void add_columns(const SlidingCells<Dim>& cells, const Steps<Dim>& home, int layers,
                   Columns columns, CellBlock& block) const {
    if (columns.to - columns.from >= most_in_run) [[unlikely]] {  // five, of which four are a run
      block.add(run_in_layer(cells, home, layers, {columns.from, columns.from + most_in_run - 1}));
      columns.from += most_in_run;
    }
    block.add(run_in_layer(cells, home, layers, columns));
  }
  /// Adds those of all layers that are within reach.
  void add_columns(const SlidingCells<Dim>& cells, const Steps<Dim>& home, const Reach& reach,
                   CellBlock& block) const {
    for (int layers = -aside_y; layers <= aside_y; ++layers) {
      add_columns(cells, home, layers, reach[static_cast<std::size_t>(layers + 1)], block);
    }
  }

 private:
  /// What a step adds to the image in which a cell is seen, in any box: a layer, if it leads there.
  static constexpr std::array<std::uint64_t, 3> per_step{
      0, std::uint64_t{1} << (32 + Neighbour::sphere_bits), 0};

  static constexpr int aside_y = Dim > 1 ? 1 : 0;
  static constexpr int aside_z = Dim > 2 ? 1 : 0;

  /// Of a layer up to four columns of the row at z = 0. A layer that has slid to the right is met
  /// at a column further left.
  CellRun run_in_layer(const SlidingCells<Dim>& cells, const Steps<Dim>& home, int layers,
                       const Columns& columns) const {
    int column = home[0] - layers * cells.whole_slide() + columns.from;
    if constexpr (Dim > 1) {
      if (cells.whole_offset() != 0) column -= periods(home[1] + layers) * cells.whole_offset();
    }
    return {at(0, column) + layer(home, layers), columns.to - columns.from + 1};
  }
  /// Adds a cell of a layer in each row.
  void add_cells(const Steps<Dim>& home, SeenCell cell, ScatteredCells& scattered) const {
    for (int row = -aside_z; row <= aside_z; ++row) scattered.add(cell + across(home, row));
  }
  /// The part of a layer so many steps along y.
  SeenCell layer(const Steps<Dim>& home, int steps) const {
    if constexpr (Dim > 1) return part(home, 1, steps);
    return {0};
  }
  /// The part of a row so many steps along z.
  SeenCell across(const Steps<Dim>& home, int row) const {
    if constexpr (Dim > 2) return part(home, 2, row);
    return {0};
  }
  SeenCell part(const Steps<Dim>& home, std::size_t axis, int steps) const {
    return at(axis, home[axis] + steps) +
           SeenCell{per_step[axis] * static_cast<std::uint64_t>(steps)};
  }
  int periods(int layer) const { return layer < 0 ? -1 : layer >= cells_[Dim > 1 ? 1 : 0] ? 1 : 0; }
  /// The part of a coordinate.
  SeenCell at(std::size_t axis, int coordinate) const {
    return parts_[axis][static_cast<std::size_t>(coordinate + before_[axis])];
  }

  Steps<Dim> cells_;
  std::array<std::int32_t, Dim> strides_{};
  std::int32_t count_ = 1;
  std::array<std::vector<SeenCell>, Dim> parts_;
  std::array<int, Dim> before_{};  ///< so many coordinates below 0 are in the table
};

}  // namespace zenosphere
