#include "flow/overlaps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "model/rewind.hpp"

namespace zenosphere {
namespace {

/// Diameters of one order of magnitude, (low, high].
struct SizeClass {
  double low;
  double high;
};

/// The spheres of a class and all smaller ones, in cells a little wider than the largest of them,
/// so that only neighbouring cells hold spheres that overlap.
class SortedSpheres {
 public:
  SortedSpheres(const PlacedSpheres& spheres, const SizeClass& sizes)
      : spheres_(spheres), sizes_(sizes) {
    const double least_width = 1.001 * sizes.high;
    constexpr double most_cells = 1 << 20;  // a side, so that the number of a cell fits in 64 bits
    for (std::size_t axis = 0; axis < dimension(); ++axis) {
      const double fitting = std::floor(spheres.sides[axis] / least_width);
      cells_[axis] = static_cast<std::int64_t>(std::clamp(fitting, 1.0, most_cells));
    }
    const std::size_t count = spheres.positions.size() / dimension();
    sorted_.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      if (diameter(i) <= sizes.high) sorted_.emplace_back(cell_of(place_of(i)), i);
    }
    std::sort(sorted_.begin(), sorted_.end());
  }

  /// Of the spheres of the class with each other and with smaller ones.
  void search(Overlap& deepest) const {
    for (const auto& [cell, i] : sorted_) {
      if (is_of_class(i)) search_around(i, deepest);
    }
  }

 private:
  using Place = std::array<double, 3>;

  std::size_t dimension() const { return spheres_.sides.size(); }
  double diameter(std::size_t i) const {
    return spheres_.diameters.empty() ? 1.0 : spheres_.diameters[i];
  }
  bool is_of_class(std::size_t i) const { return diameter(i) > sizes_.low; }
  bool is_immobile(std::size_t i) const {
    return !spheres_.immobile.empty() && spheres_.immobile[i] != 0;
  }
  bool is_closed(std::size_t axis) const { return spheres_.closed == static_cast<int>(axis); }

  Place place_of(std::size_t i) const {
    Place place{};
    for (std::size_t axis = 0; axis < dimension(); ++axis) {
      place[axis] = spheres_.positions[i * dimension() + axis];
    }
    return place;
  }

  std::int64_t cell_along(std::size_t axis, double position) const {
    const double width = spheres_.sides[axis] / static_cast<double>(cells_[axis]);
    const auto cell = static_cast<std::int64_t>(std::floor(position / width));
    return std::clamp<std::int64_t>(cell, 0, cells_[axis] - 1);
  }

  std::int64_t cell_of(const Place& place) const {
    std::int64_t cell = 0;
    for (std::size_t axis = dimension(); axis-- > 0;) {  // x fastest: a row is a run of cells
      cell = cell * cells_[axis] + cell_along(axis, place[axis]);
    }
    return cell;
  }

  /// Looks at the rows of cells around a sphere, for each at the three columns next to it.
  void search_around(std::size_t i, Overlap& deepest) const {
    const Place place = place_of(i);
    const int layers = dimension() > 1 ? 1 : 0;
    const int planes = dimension() > 2 ? 1 : 0;
    for (int plane = -planes; plane <= planes; ++plane) {
      for (int layer = -layers; layer <= layers; ++layer) {
        search_row(i, place, layer, plane, deepest);
      }
    }
  }

  void search_row(std::size_t i, const Place& place, int layer, int plane, Overlap& deepest) const {
    const std::array<int, 3> steps{0, layer, plane};
    std::int64_t row = 0;
    double x = place[0];
    for (std::size_t axis = dimension(); axis-- > 1;) {
      const std::int64_t cells = cells_[axis];
      const std::int64_t wanted = cell_along(axis, place[axis]) + steps[axis];
      const std::int64_t around = wanted < 0 ? -1 : wanted >= cells ? 1 : 0;
      if (around != 0 && is_closed(axis)) return;
      row = row * cells + (wanted - around * cells);
      if (axis == 1) x -= static_cast<double>(around) * spheres_.offset;
    }
    const double side = spheres_.sides[0];
    const std::int64_t column = cell_along(0, x - side * std::floor(x / side));
    for (std::int64_t next = column - 1; next <= column + 1; ++next) {
      const std::int64_t wrapped = (next + cells_[0]) % cells_[0];
      search_cell(i, place, row * cells_[0] + wrapped, deepest);
    }
  }

  void search_cell(std::size_t i, const Place& place, std::int64_t cell, Overlap& deepest) const {
    auto found = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair(cell, std::size_t{0}));
    for (; found != sorted_.end() && found->first == cell; ++found) {
      const std::size_t j = found->second;
      if (j <= i && is_of_class(j)) continue;  // each pair once
      const double sigma = (diameter(i) + diameter(j)) / 2;
      const double depth = sigma - distance(place, place_of(j));
      if (!(depth > deepest.depth) || (is_immobile(i) && is_immobile(j))) continue;
      const auto [first, second] = std::minmax(i, j);
      deepest = {static_cast<std::int64_t>(first), static_cast<std::int64_t>(second), depth};
    }
  }

  /// Between nearest images: the layers first, since they displace the columns.
  double distance(const Place& a, const Place& b) const {
    double square = 0;
    double displaced = 0;
    for (std::size_t axis = dimension(); axis-- > 0;) {
      double along = b[axis] - a[axis] - (axis == 0 ? displaced : 0.0);
      if (!is_closed(axis)) {
        const double periods = std::round(along / spheres_.sides[axis]);
        along -= periods * spheres_.sides[axis];
        if (axis == 1) displaced = periods * spheres_.offset;
      }
      square += along * along;
    }
    return std::sqrt(square);
  }

  const PlacedSpheres& spheres_;
  SizeClass sizes_;
  std::array<std::int64_t, 3> cells_{};
  std::vector<std::pair<std::int64_t, std::size_t>> sorted_;  ///< cell, sphere
};

/// The largest diameter up to a limit; 0 where there is none.
double largest_up_to(double limit, const PlacedSpheres& spheres) {
  if (spheres.diameters.empty()) return limit >= 1 ? 1 : 0;
  double largest = 0;
  for (const double diameter : spheres.diameters) {
    if (diameter <= limit) largest = std::max(largest, diameter);
  }
  return largest;
}

}  // namespace

double deepest_permitted(OverlapRule rule, double guard, double time, double longest_side,
                         double largest) {
  // Starts may overlap by 1e-12; a flight through a long box rounds a place by some ulps of its
  // side, each time that it is given another image: 94 have been seen.
  constexpr double most_ulps = 256;
  const double by_rounding =
      std::max(1e-9, most_ulps * std::numeric_limits<double>::epsilon() * longest_side);
  switch (rule) {
    case OverlapRule::rewind:
      return by_rounding +
             2 * longest_way_back(longest_side, std::numeric_limits<double>::epsilon(), largest);
    case OverlapRule::guarded:
      return by_rounding + guard * time;
    case OverlapRule::immediate:
    case OverlapRule::stop:
      break;
  }
  return by_rounding;
}

Overlap deepest_overlap(const PlacedSpheres& spheres) {
  // Small spheres are sorted anew among themselves: in cells for the large ones they would all be
  // compared with each other.
  Overlap deepest;
  double high = largest_up_to(std::numeric_limits<double>::infinity(), spheres);
  while (high > 0) {
    const SizeClass sizes{high / 2, high};
    SortedSpheres(spheres, sizes).search(deepest);
    high = largest_up_to(sizes.low, spheres);
  }
  return deepest;
}

}  // namespace zenosphere
