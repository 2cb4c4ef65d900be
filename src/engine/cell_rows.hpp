#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/simd/members_in_runs.hpp"
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
  /// At most so many runs make up the rows beside a cell.
  static constexpr std::size_t most_runs = 3 * 3 * 2;

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

  /// Writes the rows around the cell at `home` to `runs`, with room for `most_runs`. Returns their
  /// end.
  CellRun* around(const SlidingCells<Dim>& cells, const Steps<Dim>& home, const Reach& reach,
                  CellRun* runs) const {
    for (int layers = -aside_y; layers <= aside_y; ++layers) {
      runs = in_layer(cells, home, layers, reach[static_cast<std::size_t>(layers + 1)], runs);
    }
    return runs;
  }
  /// The same of one layer.
  CellRun* in_layer(const SlidingCells<Dim>& cells, const Steps<Dim>& home, int layers,
                    const Columns& columns, CellRun* runs) const {
    if (columns.to - columns.from >= most_in_run) [[unlikely]] {
      const int next = columns.from + most_in_run;
      runs = in_layer(cells, home, layers, {columns.from, next - 1}, runs);
      return in_layer(cells, home, layers, {next, columns.to}, runs);
    }
    const CellRun run = run_in_layer(cells, home, layers, columns);
    for (int row = -aside_z; row <= aside_z; ++row) *runs++ = run.beyond(across(home, row));
    return runs;
  }
  /// The same of one row of each layer.
  CellRun* in_row(const SlidingCells<Dim>& cells, const Steps<Dim>& home, int row,
                  const Reach& reach, CellRun* runs) const {
    const std::uint64_t across = this->across(home, row);
    for (int layers = -aside_y; layers <= aside_y; ++layers) {
      auto [from, to] = reach[static_cast<std::size_t>(layers + 1)];
      if (to - from >= most_in_run) [[unlikely]] {  // five, of which four are a run
        const Columns first{from, from + most_in_run - 1};
        *runs++ = run_in_layer(cells, home, layers, first).beyond(across);
        from += most_in_run;
      }
      *runs++ = run_in_layer(cells, home, layers, {from, to}).beyond(across);
    }
    return runs;
  }

  /// One cell of each of the rows around the cell at `home`, in a column of each layer.
  ///
  /// \param columns  of the layers below, beside and above, counted as those of a Reach
  ScatteredCells one_of_each_row(const SlidingCells<Dim>& cells, const Steps<Dim>& home,
                                 const std::array<int, 3>& columns) const {
    ScatteredCells scattered;
    for (int layers = -aside_y; layers <= aside_y; ++layers) {
      const int column = columns[static_cast<std::size_t>(layers + 1)];
      const CellRun run = run_in_layer(cells, home, layers, {column, column});
      for (int row = -aside_z; row <= aside_z; ++row) {
        scattered.add(run.beyond(across(home, row)).place);
      }
    }
    return scattered;
  }

 private:
  static constexpr std::uint64_t one_layer = std::uint64_t{1} << (32 + Neighbour::sphere_bits);

  static constexpr int aside_y = Dim > 1 ? 1 : 0;
  static constexpr int aside_z = Dim > 2 ? 1 : 0;

  /// Of a layer up to four columns of the row at z = 0. A layer that has slid to the right is met
  /// at a column further left.
  CellRun run_in_layer(const SlidingCells<Dim>& cells, const Steps<Dim>& home, int layers,
                       const Columns& columns) const {
    int column = home[0] - layers * cells.whole_slide() + columns.from;
    std::uint64_t place = 0;
    if constexpr (Dim > 1) {
      const int layer = home[1] + layers;
      if (cells.whole_offset() != 0) column -= periods(layer) * cells.whole_offset();
      place = at(1, layer) + one_layer * static_cast<std::uint64_t>(layers);
    }
    return CellRun::of(place + at(0, column), columns.to - columns.from + 1);
  }
  /// What a row so many steps along z adds to the place of a run.
  std::uint64_t across(const Steps<Dim>& home, int row) const {
    if constexpr (Dim > 2) return at(2, home[2] + row);
    return 0;
  }
  int periods(int layer) const { return layer < 0 ? -1 : layer >= cells_[Dim > 1 ? 1 : 0] ? 1 : 0; }
  /// What a coordinate adds to the place of a run.
  std::uint64_t at(std::size_t axis, int coordinate) const {
    return places_[axis][static_cast<std::size_t>(coordinate + before_[axis])];
  }

  Steps<Dim> cells_;
  std::array<std::int32_t, Dim> strides_{};
  std::int32_t count_ = 1;
  std::array<std::vector<std::uint64_t>, Dim> places_;
  std::array<int, Dim> before_{};  ///< so many coordinates below 0 are in the table
};

}  // namespace zenosphere
