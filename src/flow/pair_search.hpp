#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "flow/sampled_system.hpp"

namespace zenosphere {

/// All pairs of spheres within a distance, found cell by cell, through periodic and sliding faces.
///
/// Spheres are sorted into cells of half the distance. Cells that follow each other along x are
/// neighbours in memory, and since a row is entered at the place where it lies now, a sliding face
/// needs no special cells.
template <int Dim>
class PairSearch {
 public:
  /// \param reach  diameters, at most system.reach()
  PairSearch(const SampledSystem<Dim>& system, const SampledMoment<Dim>& moment, double reach)
      : system_(system), offset_(moment.offset), reach_(reach) {
    for (int axis = 0; axis < Dim; ++axis) {
      const double most = std::ceil(std::pow(system.spheres, 1.0 / Dim)) + 1;  // no empty lattice
      const double fitting = std::floor(2 * system.sides[axis] / reach);
      cells_[at(axis)] = static_cast<int>(std::clamp(fitting, 1.0, most));
      width_[axis] = system.sides[axis] / cells_[at(axis)];
    }
    sort(moment.positions);
  }

  /// Calls `visit(i, j, dr, r2)` once for each pair: dr from i to j, r2 = dr.dr.
  template <class Visit>
  void visit(Visit visit) const {
    for (std::size_t n = 0; n < order_.size(); ++n) visit_rows(n, Dim - 1, Row{}, visit);
  }

 private:
  using Vector = Vec<Dim, double>;

  /// A row of cells along x, as it is seen from a sphere.
  struct Row {
    int cell = 0;       ///< number of its first cell
    Vector shift{};     ///< of the image in which it is seen
    double square = 0;  ///< of the distance that it keeps at least
  };

  static std::size_t at(int axis) { return static_cast<std::size_t>(axis); }
  static int floored(int cell, int cells) {
    return cell >= 0 ? cell / cells : -((cells - 1 - cell) / cells);
  }

  int coordinate(const Vector& place, int axis) const {
    return std::clamp(static_cast<int>(place[axis] / width_[axis]), 0, cells_[at(axis)] - 1);
  }
  int stride(int axis) const {
    return std::accumulate(cells_.begin(), cells_.begin() + axis, 1, std::multiplies<>());
  }
  int row_of(const Vector& place) const {
    int cell = 0;
    for (int axis = 1; axis < Dim; ++axis) cell += coordinate(place, axis) * stride(axis);
    return cell;
  }

  void sort(const std::vector<Vector>& positions) {
    std::vector<int> cell;
    for (const Vector& place : positions) cell.push_back(row_of(place) + coordinate(place, 0));
    begin_.assign(static_cast<std::size_t>(stride(Dim)) + 1, 0);
    for (const int each : cell) ++begin_[static_cast<std::size_t>(each) + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    order_.resize(positions.size());
    auto next = begin_;
    for (std::size_t i = 0; i < positions.size(); ++i) {
      order_[next[static_cast<std::size_t>(cell[i])]++] = static_cast<std::int32_t>(i);
    }
    for (const std::int32_t i : order_) places_.push_back(positions[static_cast<std::size_t>(i)]);
  }

  /// Goes through the rows within reach of sorted sphere `n`, axis by axis down to x.
  template <class Visit>
  void visit_rows(std::size_t n, int axis, const Row& row, Visit& visit) const {
    if (axis == 0) return visit_row(n, row, visit);
    const int cells = cells_[at(axis)];
    const double place = places_[n][axis];
    const int first = static_cast<int>(std::floor((place - reach_) / width_[axis]));
    const int last = static_cast<int>(std::floor((place + reach_) / width_[axis]));
    for (int cell = first; cell <= last; ++cell) {
      const int image = floored(cell, cells);
      if (image != 0 && system_.closed_axis == axis) continue;
      const double below = cell * width_[axis] - place, above = place - (cell + 1) * width_[axis];
      const double apart = std::max({below, above, 0.0});
      Row next = row;
      next.cell += (cell - image * cells) * stride(axis);
      next.shift[axis] = image * system_.sides[axis];
      if (axis == 1) next.shift[0] += image * offset_;
      next.square += apart * apart;
      if (next.square <= reach_ * reach_) visit_rows(n, axis - 1, next, visit);
    }
  }

  /// Visits those spheres of a row that come behind sorted sphere `n`.
  template <class Visit>
  void visit_row(std::size_t n, const Row& row, Visit& visit) const {
    if (row.cell < row_of(places_[n])) return;
    const int cells = cells_[0];
    const double half = std::sqrt(reach_ * reach_ - row.square) + rounding;
    const double middle = places_[n][0] - row.shift[0];
    const int first = static_cast<int>(std::floor((middle - half) / width_[0]));
    const int last = static_cast<int>(std::floor((middle + half) / width_[0]));
    for (int image = floored(first, cells); image <= floored(last, cells); ++image) {
      if (image != 0 && system_.closed_axis == 0) continue;
      const int begin = std::max(first - image * cells, 0);
      const int end = std::min(last - image * cells + 1, cells);
      Vector shift = row.shift;
      shift[0] += image * system_.sides[0];
      visit_span(n, begin_[static_cast<std::size_t>(row.cell + begin)],
                 begin_[static_cast<std::size_t>(row.cell + end)], shift, visit);
    }
  }

  template <class Visit>
  void visit_span(std::size_t n, std::size_t begin, std::size_t end, const Vector& shift,
                  Visit& visit) const {
    const Vector origin = places_[n] - shift;
    for (std::size_t m = std::max(begin, n + 1); m < end; ++m) {
      const Vector dr = places_[m] - origin;
      const double r2 = dot(dr, dr);
      if (r2 <= reach_ * reach_) visit(order_[n], order_[m], dr, r2);
    }
  }

  static constexpr double rounding = 1e-9;  ///< of places, generously, diameters

  const SampledSystem<Dim>& system_;
  double offset_, reach_;
  std::array<int, Dim> cells_{};
  Vector width_;
  std::vector<std::size_t> begin_;   ///< of each cell in the two below
  std::vector<std::int32_t> order_;  ///< spheres, cell by cell
  std::vector<Vector> places_;       ///< of these
};

}  // namespace zenosphere
