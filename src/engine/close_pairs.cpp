#include "engine/close_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "engine/cell_lists.hpp"
#include "model/instantiate.hpp"
#include "model/power.hpp"

namespace zenosphere {

namespace {

/// Cells along each axis that are as wide as a reach at least, and not many more than spheres.
template <int Dim>
Steps<Dim> fitting_cells(const ShearBox<Dim, double>& box, double reach, std::size_t spheres) {
  Steps<Dim> cells{};
  double most = 1;
  while (power<Dim>(most) < 8.0 * static_cast<double>(spheres)) ++most;
  for (int axis = 0; axis < Dim; ++axis) {
    const double fitting = std::floor(box.sides()[axis] / (reach * (1 + 1e-9)));
    cells[static_cast<std::size_t>(axis)] = static_cast<int>(std::clamp(fitting, 1.0, most));
  }
  return cells;
}

/// The spheres of one octave of diameters, in cells that are as wide as the largest reaches.
template <int Dim>
class Grid {
 public:
  Grid(const ShearBox<Dim, double>& box, std::span<const Vec<Dim, double>> positions,
       const std::vector<std::int32_t>& members, double reach)
      : box_(box),
        cells_(fitting_cells(box, reach, members.size())),
        lists_(count(), static_cast<std::int32_t>(positions.size())) {
    for (const std::int32_t i : members) {
      lists_.insert(i, index(coordinates(positions[static_cast<std::size_t>(i)])));
    }
  }

  /// Calls `visit(j)` for each member in the cell of a place and in those around it.
  template <class Visit>
  void around(const Vec<Dim, double>& place, const Visit& visit) const {
    Steps<Dim> cell = coordinates(place);
    around(cell, 0, visit);
  }

 private:
  template <class Visit>
  void around(Steps<Dim>& cell, std::size_t axis, const Visit& visit) const {
    if (axis == Dim) {
      for (std::int32_t j = lists_.first(index(cell)); j >= 0; j = lists_.next(j)) visit(j);
      return;
    }
    const int home = cell[axis];
    const int side = cells_[axis];
    const bool is_closed = box_.is_closed(static_cast<int>(axis));
    const bool is_whole = !is_closed && side < 3;  // or a cell would be visited twice
    for (int c = is_whole ? 0 : home - 1; c <= (is_whole ? side - 1 : home + 1); ++c) {
      if (is_closed && (c < 0 || c >= side)) continue;
      cell[axis] = (c + side) % side;
      around(cell, axis + 1, visit);
    }
    cell[axis] = home;
  }

  Steps<Dim> coordinates(const Vec<Dim, double>& place) const {
    Steps<Dim> result{};
    for (int axis = 0; axis < Dim; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const double cell = place[axis] / box_.sides()[axis] * cells_[a];
      result[a] = std::clamp(static_cast<int>(cell), 0, cells_[a] - 1);
    }
    return result;
  }

  std::int32_t index(const Steps<Dim>& cell) const {
    std::int32_t result = 0;
    for (std::size_t axis = 0; axis < Dim; ++axis) result = result * cells_[axis] + cell[axis];
    return result;
  }

  std::int32_t count() const {
    std::int32_t result = 1;
    for (const int side : cells_) result *= side;
    return result;
  }

  const ShearBox<Dim, double>& box_;
  Steps<Dim> cells_;
  CellLists lists_;
};

/// Finds the pairs of one call of close_pairs().
template <int Dim>
class PairSearch {
 public:
  PairSearch(std::span<const Vec<Dim, double>> positions, std::span<const double> diameters,
             const ShearBox<Dim, double>& box, double margin)
      : positions_(positions), diameters_(diameters), box_(box), margin_(margin) {}

  std::vector<ClosePair<Dim>> pairs() {
    const std::vector<std::vector<std::int32_t>> octaves = by_octave();
    for (std::size_t octave = 0; octave < octaves.size(); ++octave) {
      if (octaves[octave].empty()) continue;
      double largest = 0;
      for (const std::int32_t i : octaves[octave]) largest = std::max(largest, diameter(i));
      const Grid<Dim> grid(box_, positions_, octaves[octave], largest + margin_);
      // The cells suit spheres that are as large as those in them, or smaller.
      for (std::size_t other = octave; other < octaves.size(); ++other) {
        for (const std::int32_t i : octaves[other]) {
          grid.around(position(i), [&](std::int32_t j) {
            if (other != octave || i < j) add(i, j);
          });
        }
      }
    }
    return std::move(found_);
  }

 private:
  const Vec<Dim, double>& position(std::int32_t i) const {
    return positions_[static_cast<std::size_t>(i)];
  }
  double diameter(std::int32_t i) const { return diameters_[static_cast<std::size_t>(i)]; }

  /// Spheres by the number of times that their diameter can be doubled up to the largest one.
  std::vector<std::vector<std::int32_t>> by_octave() const {
    const double largest = *std::max_element(diameters_.begin(), diameters_.end());
    std::vector<std::vector<std::int32_t>> octaves;
    for (std::size_t i = 0; i < diameters_.size(); ++i) {
      int octave = 0;
      std::frexp(largest / diameters_[i], &octave);  // 1 for [1, 2), 2 for [2, 4)
      const auto number = static_cast<std::size_t>(octave - 1);
      if (octaves.size() <= number) octaves.resize(number + 1);
      octaves[number].push_back(static_cast<std::int32_t>(i));
    }
    return octaves;
  }

  /// Adds the nearest image of a pair, and in a small box others that are close too.
  void add(std::int32_t i, std::int32_t j) {
    const double reach = (diameter(i) + diameter(j)) / 2 + margin_;
    Vec<Dim, double> shift;
    const Vec<Dim, double> apart = position(j) - position(i);
    bool is_small = false;
    for (int axis = 0; axis < Dim; ++axis) {
      if (box_.is_closed(axis)) continue;
      const double side = box_.sides()[axis];
      shift[axis] = -side * std::round(apart[axis] / side);
      is_small = is_small || reach > side / 2;
    }
    if (is_small) return add_images(i, j, reach, shift, 0);
    add_if_close(i, j, reach, shift);
  }

  void add_images(std::int32_t i, std::int32_t j, double reach, const Vec<Dim, double>& shift,
                  int axis) {
    if (axis == Dim) return add_if_close(i, j, reach, shift);
    for (int image = -1; image <= 1; ++image) {
      if (image != 0 && box_.is_closed(axis)) continue;
      Vec<Dim, double> shifted = shift;
      shifted[axis] += image * box_.sides()[axis];
      add_images(i, j, reach, shifted, axis + 1);
    }
  }

  void add_if_close(std::int32_t i, std::int32_t j, double reach, const Vec<Dim, double>& shift) {
    const Vec<Dim, double> apart = position(j) + shift - position(i);
    if (dot(apart, apart) < reach * reach) found_.push_back({i, j, shift});
  }

  std::span<const Vec<Dim, double>> positions_;
  std::span<const double> diameters_;
  const ShearBox<Dim, double>& box_;
  double margin_;
  std::vector<ClosePair<Dim>> found_;
};

}  // namespace

template <int Dim>
std::vector<ClosePair<Dim>> close_pairs(std::span<const Vec<Dim, double>> positions,
                                        std::span<const double> diameters,
                                        const ShearBox<Dim, double>& box, double margin) {
  return PairSearch<Dim>(positions, diameters, box, margin).pairs();
}

#define ZENOSPHERE_INSTANTIATE(Dim)                                                        \
  template std::vector<ClosePair<Dim>> close_pairs<Dim>(std::span<const Vec<Dim, double>>, \
                                                        std::span<const double>,           \
                                                        const ShearBox<Dim, double>&, double);
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
