#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/periodic_image.hpp"
#include "model/shear_box.hpp"

namespace zenosphere {

/// Cells by which the layers below and above a cell are displaced against it, beside whole ones.
struct LayerSlides {
  double below;
  double above;
};

/// Cells that are seen from one: three rows of three, in each of which there are at most five.
inline constexpr std::size_t most_cells_around = 3 * 3 * 5;

/// Which cells are neighbours while the layers slide.
///
/// Cells are numbered along x first. A column of layer k + 1 that starts above column c of layer k
/// has slid by whole cells and a fraction after a while; the whole cells are kept here, the
/// fraction is the remainder of the clock. The images of the box along y may have been displaced at
/// the start already. Nothing in here knows about lengths or times.
template <int Dim>
class SlidingCells {
 public:
  /// \param cells    number of cells along each axis, >= 2
  explicit SlidingCells(const Steps<Dim>& cells) : cells_(cells) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      strides_[axis] = count_;
      per_stride_[axis] = 1.0 / count_;
      count_ *= cells[axis];
    }
  }

  std::int32_t count() const { return count_; }
  std::int32_t index(const Steps<Dim>& coordinates) const {
    std::int32_t cell = 0;
    for (std::size_t axis = 0; axis < Dim; ++axis) cell += coordinates[axis] * strides_[axis];
    return cell;
  }
  Steps<Dim> coordinates(std::int32_t cell) const {
    Steps<Dim> coordinates{};
    for (std::size_t axis = Dim - 1; axis > 0; --axis) {
      // A quotient of integers below 2^31 by way of a product in double: exact, and no division.
      coordinates[axis] = static_cast<int>((cell + 0.5) * per_stride_[axis]);
      cell -= coordinates[axis] * strides_[axis];
    }
    coordinates[0] = cell;
    return coordinates;
  }

  /// Columns of a row, counted from the one that lies beside a cell when no layer has slid by a
  /// fraction of a cell.
  struct Columns {
    int from;
    int to;
  };
  /// Those of the layers below, beside and above.
  using Reach = std::array<Columns, 3>;

  /// Rows beside a cell: from how many layers and rows below it to how many above.
  struct Rows {
    int first_layer = -1, last_layer = 1;  ///< along y
    int first_row = -1, last_row = 1;      ///< along z
  };
  /// All of them, known to the compiler.
  struct AllRows {
    static constexpr int first_layer = -1, last_layer = 1;
    static constexpr int first_row = -1, last_row = 1;
  };

  /// Steps along the gradient direction: how many layers up.
  static int layers(const Steps<Dim>& steps) { return Dim > 1 ? steps[Dim > 1 ? 1 : 0] : 0; }

  /// Calls `visit(first, last, image, steps to the first)` for the runs of cells `first`, first +
  /// 1,
  /// ... `last` that make up the rows beside the cell at `home`. In a narrow box a row may lead
  /// through a cell more than once, in another image.
  template <class Visit>
  void for_each_run(const Steps<Dim>& home, const Reach& reach, Visit visit) const {
    for_each_run(home, reach, AllRows(), visit);
  }
  /// The same of some of these rows: Rows, or AllRows.
  template <class SeenRows, class Visit>
  void for_each_run(const Steps<Dim>& home, const Reach& reach, const SeenRows& seen,
                    Visit visit) const {
    constexpr std::size_t y = Dim > 1 ? 1 : 0;
    constexpr std::size_t z = Dim > 2 ? 2 : 0;
    constexpr int aside_y = Dim > 1 ? 1 : 0;
    constexpr int aside_z = Dim > 2 ? 1 : 0;
    struct Row {
      std::int32_t base = 0;  ///< its first cell in the lowest layer
      int periods = 0;        ///< along z
    };
    const int first_layer = aside_y * seen.first_layer;
    const int last_layer = aside_y * seen.last_layer;
    const int first_row = aside_z * seen.first_row;
    const int last_row = aside_z * seen.last_row;
    std::array<Row, 1 + 2 * aside_z> rows;
    if constexpr (Dim > 2) {
      for (int step = first_row; step <= last_row; ++step) {
        Row& row = rows[static_cast<std::size_t>(step + 1)];
        row.base = wrapped(home[z] + step, cells_[z], row.periods) * strides_[z];
      }
    }
    const int side = cells_[0];
    for (int layers = first_layer; layers <= last_layer; ++layers) {
      Steps<Dim> periods{};
      std::int32_t layer = 0;
      if constexpr (Dim > 1) layer = wrapped(home[y] + layers, cells_[y], periods[y]) * strides_[y];
      // A layer that has slid to the right is met at a column further left.
      const auto [from, to] = reach[static_cast<std::size_t>(layers + 1)];
      int column = home[0] - layers * whole_slide_ + from;
      if constexpr (Dim > 1) column -= periods[y] * whole_offset_;
      for (; column < 0; column += side) --periods[0];
      for (; column >= side; column -= side) ++periods[0];
      for (int step = from; step <= to; ++periods[0], column = 0) {
        const int last = std::min(column + to - step, side - 1);
        const PeriodicImage periodic_image(periods, layers);
        Steps<Dim> steps{step};
        if constexpr (Dim > 1) steps[1] = layers;
        for (int along_z = first_row; along_z <= last_row; ++along_z) {
          const Row& row = rows[static_cast<std::size_t>(along_z + aside_z)];
          if constexpr (Dim > 2) steps[2] = along_z;
          visit(layer + row.base + column, layer + row.base + last,
                periodic_image.beyond_z(row.periods), steps);
        }
        step += last - column + 1;
      }
    }
  }

  /// How a cell is reached from another one, by the shorter way around.
  struct Reached {
    Steps<Dim> steps;
    Steps<Dim> periods;
  };
  Reached reached(const Steps<Dim>& home, const Steps<Dim>& there) const {
    Reached reached{};
    for (std::size_t axis = Dim; axis-- > 0;) {  // the layer first: it decides about the column
      int& steps = reached.steps[axis];
      int& periods = reached.periods[axis];
      steps = there[axis] - home[axis];
      if constexpr (Dim > 1) {
        if (axis == 0)
          steps += reached.steps[1] * whole_slide_ + reached.periods[1] * whole_offset_;
      }
      const int half = cells_[axis] / 2;
      for (; steps > half; steps -= cells_[axis]) --periods;
      for (; steps < -half; steps += cells_[axis]) ++periods;
    }
    return reached;
  }

  const Steps<Dim>& cells() const { return cells_; }

  /// Whole cells by which a layer has slid against the one below it; in [0, cells along x).
  int whole_slide() const { return whole_slide_; }
  void slide_to(int whole_cells) { whole_slide_ = whole_cells; }

  /// Whole cells by which the upper image of the box was displaced at the start; at most half the
  /// cells along x either way.
  int whole_offset() const { return whole_offset_; }
  void displace_images(int whole_cells) { whole_offset_ = whole_cells; }

  /// Every layer has slid by one more whole cell against the layer below it.
  void slide_by_one_cell() { whole_slide_ = whole_slide_ + 1 == cells_[0] ? 0 : whole_slide_ + 1; }

 private:
  /// A coordinate at most one step outside, put into the box; and where it was outside.
  static int wrapped(int coordinate, int side, int& periods) {
    periods = coordinate < 0 ? -1 : coordinate >= side ? 1 : 0;
    return coordinate - periods * side;
  }

  Steps<Dim> cells_;
  std::array<std::int32_t, Dim> strides_{};
  std::array<double, Dim> per_stride_{};
  int whole_slide_ = 0;
  int whole_offset_ = 0;
  std::int32_t count_ = 1;
};

}  // namespace zenosphere
