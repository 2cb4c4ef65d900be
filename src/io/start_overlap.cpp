#include "io/start_overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace zenosphere {
namespace {

/// Spheres sorted by the cells in which they are. A cell is a little wider than a sphere, so that
/// only spheres of neighbouring cells can overlap.
class CellList {
 public:
  CellList(const std::vector<double>& positions, const std::vector<double>& sides,
           std::optional<int> closed)
      : positions_(positions), sides_(sides), closed_(closed) {
    // In a long box rounding leaves more: half an ulp for each coordinate and for the difference.
    const double longest = *std::max_element(sides.begin(), sides.end());
    const double rounding = 2 * std::numeric_limits<double>::epsilon() * longest;
    least_distance_ = 1 - std::max(touching, rounding);
    constexpr double least_width = 1.001;
    constexpr double most_cells = 1 << 20;  // a side, so that the number of a cell fits in 64 bits
    for (const double side : sides) {
      const double fitting = std::floor(side / least_width);
      cells_.push_back(static_cast<std::int64_t>(std::clamp(fitting, 1.0, most_cells)));
    }
    const auto spheres = static_cast<std::int64_t>(positions.size() / sides.size());
    for (std::int64_t i = 0; i < spheres; ++i) sorted_.emplace_back(cell_of(i), i);
    std::sort(sorted_.begin(), sorted_.end());
  }

  std::optional<OverlappingPair> first_overlap() const {
    std::optional<OverlappingPair> first;
    for (const auto& [cell, i] : sorted_) {
      if (first && i > first->i) continue;
      search(i, 0, 0, first);
    }
    return first;
  }

 private:
  double component(std::int64_t i, std::size_t axis) const {
    return positions_[static_cast<std::size_t>(i) * sides_.size() + axis];
  }

  std::int64_t cell_along(std::int64_t i, std::size_t axis) const {
    const double width = sides_[axis] / static_cast<double>(cells_[axis]);
    return std::min(static_cast<std::int64_t>(component(i, axis) / width), cells_[axis] - 1);
  }

  std::int64_t cell_of(std::int64_t i) const {
    std::int64_t cell = 0;
    for (std::size_t axis = 0; axis < sides_.size(); ++axis) {
      cell = cell * cells_[axis] + cell_along(i, axis);
    }
    return cell;
  }

  double distance(std::int64_t i, std::int64_t j) const {
    double square = 0;
    for (std::size_t axis = 0; axis < sides_.size(); ++axis) {
      double along = component(i, axis) - component(j, axis);
      const bool periodic = closed_ != static_cast<int>(axis);
      if (periodic) along -= sides_[axis] * std::round(along / sides_[axis]);
      square += along * along;
    }
    return std::sqrt(square);
  }

  /// Looks at the cells around sphere i, one axis after the other. `cell` is their number as far as
  /// the axes before `axis` tell it.
  void search(std::int64_t i, std::size_t axis, std::int64_t cell,
              std::optional<OverlappingPair>& first) const {
    if (axis == sides_.size()) return search_cell(i, cell, first);
    const std::int64_t cells = cells_[axis];
    const bool periodic = closed_ != static_cast<int>(axis);
    const std::int64_t around = std::min<std::int64_t>(cells, 3);  // two cells are neighbours once
    const std::int64_t lowest = cell_along(i, axis) - (cells > 2 ? 1 : 0);
    for (std::int64_t next = lowest; next < lowest + around; ++next) {
      const bool is_inside = next >= 0 && next < cells;
      if (!is_inside && !periodic && cells > 2) continue;
      search(i, axis + 1, cell * cells + (next + cells) % cells, first);
    }
  }

  void search_cell(std::int64_t i, std::int64_t cell, std::optional<OverlappingPair>& first) const {
    auto found = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair(cell, i + 1));
    for (; found != sorted_.end() && found->first == cell; ++found) {
      const std::int64_t j = found->second;
      const double apart = distance(i, j);
      if (apart >= least_distance_) continue;
      const bool is_earlier = !first || std::pair(i, j) < std::pair(first->i, first->j);
      if (is_earlier) first = OverlappingPair{i, j, apart};
      return;  // those behind have larger numbers
    }
  }

  const std::vector<double>& positions_;
  const std::vector<double>& sides_;
  std::optional<int> closed_;
  double least_distance_;
  std::vector<std::int64_t> cells_;
  std::vector<std::pair<std::int64_t, std::int64_t>> sorted_;  ///< cell, sphere
};

}  // namespace

std::optional<OverlappingPair> first_overlap(const std::vector<double>& positions,
                                             const std::vector<double>& sides,
                                             std::optional<int> closed) {
  return CellList(positions, sides, closed).first_overlap();
}

}  // namespace zenosphere
