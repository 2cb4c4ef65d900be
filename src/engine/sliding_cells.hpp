#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "model/shear_box.hpp"

namespace zenosphere {

/// Which spheres are in which cell, and which cells are neighbours while the layers slide.
///
/// Cells are numbered along x first. A column of layer k + 1 that starts above column c of layer k
/// has slid by whole cells and a fraction after a while; the whole cells are kept here, the
/// fraction is the remainder of the clock. Nothing in here knows about lengths or times.
template <int Dim>
class SlidingCells {
 public:
  static constexpr std::int32_t kNone = -1;

  /// Cells side by side along x in one row of a neighbourhood.
  struct Row {
    Steps<Dim> steps;  ///< to the row; zero along x
    int from;          ///< first column, relative to where the row has slid
    int to;            ///< last column
  };
  using Stencil = std::vector<Row>;

  /// \param cells    number of cells along each axis, >= 2
  /// \param sliding  whether layers slide against each other, which widens the neighbourhood
  /// \param closed_axis  the axis along which the last layer stays empty and no way leads around
  SlidingCells(const Steps<Dim>& cells, bool sliding, std::int32_t spheres,
               std::optional<int> closed_axis = std::nullopt);

  std::int32_t count() const { return static_cast<std::int32_t>(first_.size()); }
  std::int32_t index(const Steps<Dim>& coordinates) const {
    std::int32_t cell = 0;
    for (std::size_t axis = 0; axis < Dim; ++axis) cell += coordinates[axis] * strides_[axis];
    return cell;
  }
  const Steps<Dim>& coordinates(std::int32_t cell) const {
    return coordinates_[static_cast<std::size_t>(cell)];
  }

  /// A cell as it lies beside another one.
  struct Neighbour {
    std::int32_t cell;
    Steps<Dim> lag;  ///< what the difference of the cells' coordinates lacks of the way to it
  };

  /// The cell that lies `steps` away from `cell` now; at most as far as a stencil reaches.
  Neighbour neighbour(std::int32_t cell, const Steps<Dim>& steps) const {
    Steps<Dim> target = coordinates(cell);
    // A layer that has slid to the right is met at a column further left.
    target[0] = wrapped(target[0] - layers(steps) * whole_slide_, cells_[0]);
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      target[axis] = wrapped(target[axis] + steps[axis], cells_[axis]);
    }
    const std::int32_t found = index(target);
    return {found, lag(cell, found, steps)};
  }

  /// Calls `visit(first, last, lag)` for the runs of cells `first`, first + 1, ... `last` that make
  /// up a row beside `cell`: one, or two where the row leads through a face of the box.
  template <class Visit>
  void for_each_run(std::int32_t cell, const Row& row, Visit visit) const {
    const Steps<Dim>& home = coordinates(cell);
    Steps<Dim> lag{};
    std::int32_t base = 0;
    for (std::size_t axis = 1; axis < Dim; ++axis) {
      const int target = wrapped(home[axis] + row.steps[axis], cells_[axis]);
      base += target * strides_[axis];
      lag[axis] = row.steps[axis] - (target - home[axis]);
    }
    const int side = cells_[0];
    const int start = wrapped(home[0] - layers(row.steps) * whole_slide_, side);
    for (int from = row.from; from <= row.to;) {
      const int first = wrapped(start + from, side);
      const int count = std::min(row.to - from + 1, side - first);
      lag[0] = from - (first - home[0]);
      visit(base + first, base + first + count - 1, lag);
      from += count;
    }
  }

  /// What the difference of the coordinates of two cells lacks of a way, of any length, between
  /// them.
  Steps<Dim> lag(std::int32_t from, std::int32_t to, const Steps<Dim>& steps) const {
    Steps<Dim> lag = steps;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      lag[axis] -= coordinates(to)[axis] - coordinates(from)[axis];
    }
    return lag;
  }

  /// Steps along the gradient direction: how many layers up.
  static int layers(const Steps<Dim>& steps) { return Dim > 1 ? steps[Dim > 1 ? 1 : 0] : 0; }

  /// The shortest way from one cell to another along an axis; ties go to the negative side.
  ///
  /// \param layers  how many layers up the way leads: along x the slide counts
  int steps_between(std::int32_t from, std::int32_t to, int axis, int layers) const;

  /// Spheres of a cell: for (id = first(cell); id != kNone; id = next(id)).
  std::int32_t first(std::int32_t cell) const { return first_[static_cast<std::size_t>(cell)]; }
  std::int32_t next(std::int32_t sphere) const { return next_[static_cast<std::size_t>(sphere)]; }

  void insert(std::int32_t sphere, std::int32_t cell);
  void remove(std::int32_t sphere, std::int32_t cell);

  /// Every layer has slid by one more whole cell against the layer below it.
  void slide_by_one_cell();

  /// Whole cells that a layer has slid, in [0, number of columns).
  int whole_slide() const { return whole_slide_; }

  /// All spheres, cell by cell and as each cell lists them: equal contact times are told apart by
  /// that order, so that a checkpoint has to keep it.
  std::vector<std::int32_t> order() const;

  /// Restores slide and lists of new cells, without spheres, from those of others.
  ///
  /// \param order       each sphere once
  /// \param cell_of     the cell of a sphere
  void restore(int whole_slide, const std::vector<std::int32_t>& order,
               const std::function<std::int32_t(std::int32_t)>& cell_of);

  /// All cells whose spheres can be touched from a cell during one clock unit: its own row of
  /// three and, under shear, four of each adjacent row, since the slide is a fraction of a cell.
  const Stencil& neighbourhood() const { return neighbourhood_; }

  /// The part of the neighbourhood that is new to a sphere after it crossed a face of its cell.
  /// \param direction  -1 or +1
  const Stencil& new_after_crossing(int axis, int direction) const {
    return after_crossing_[static_cast<std::size_t>(2 * axis + (direction > 0 ? 1 : 0))];
  }

  /// The part of the neighbourhood that is new to every sphere after slide_by_one_cell().
  const Stencil& new_after_slide() const { return after_slide_; }

 private:
  void build_stencils(bool sliding);

  static int wrapped(int coordinate, int side) {
    return coordinate < 0 ? coordinate + side : coordinate >= side ? coordinate - side : coordinate;
  }

  Steps<Dim> cells_;
  std::optional<int> closed_axis_;
  std::array<std::int32_t, Dim> strides_{};
  int whole_slide_ = 0;  ///< in [0, cells_[0])
  std::vector<std::int32_t> first_;
  std::vector<std::int32_t> next_;
  std::vector<std::int32_t> prev_;
  std::vector<Steps<Dim>> coordinates_;
  Stencil neighbourhood_;
  std::array<Stencil, 2 * Dim> after_crossing_;
  Stencil after_slide_;
};

}  // namespace zenosphere
