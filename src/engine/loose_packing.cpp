#include "engine/loose_packing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "engine/cell_lists.hpp"
#include "engine/rods.hpp"
#include "engine/sliding_cells.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

/// Points in a box that are pushed apart until they keep a distance.
template <int Dim>
class Pushing {
 public:
  Pushing(std::int32_t spheres, const ShearBox<Dim, double>& box, Random& random)
      : box_(box.sides(), 0, least_width(spheres, box.sides()), box.closed_axis()),
        cells_(box_.cells()),
        lists_(cells_.count(), spheres),
        positions_(static_cast<std::size_t>(spheres)),
        home_(static_cast<std::size_t>(spheres)) {
    for (std::int32_t i = 0; i < spheres; ++i) {
      for (int axis = 0; axis < Dim; ++axis) {
        const double margin = box_.is_closed(axis) ? 0.5 : 0;
        position(i)[axis] = margin + (box_.sides()[axis] - 2 * margin) * random.uniform();
      }
      home_[static_cast<std::size_t>(i)] = cell_of(position(i));
      lists_.insert(i, home_[static_cast<std::size_t>(i)]);
    }
  }

  /// Pushes every pair closer than `distance` to that distance; returns whether there was one
  /// closer than a diameter.
  bool sweep(double distance) {
    bool overlap = false;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(positions_.size()); ++i) {
      overlap |= push_from_surroundings(i, distance);
    }
    return overlap;
  }

  const std::vector<Vec<Dim, double>>& positions() const { return positions_; }

 private:
  static constexpr std::size_t y_axis = Dim > 1 ? 1 : 0, z_axis = Dim > 2 ? 2 : 0;
  static constexpr std::size_t rows_y = Dim > 1 ? 3 : 1, rows_z = Dim > 2 ? 3 : 1;

  /// The cells beside one: what each step of -1, 0, 1 along each axis adds to their number.
  struct Surroundings {
    std::int32_t home = -1;
    std::array<std::array<std::int32_t, 3>, Dim> parts{};
  };

  Surroundings surroundings(std::int32_t home) const {
    Surroundings around{home};
    const Steps<Dim> coordinates = cells_.coordinates(home);
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const int side = box_.cells()[axis];
      for (int step = -1; step <= 1; ++step) {
        Steps<Dim> there{};
        there[axis] = (coordinates[axis] + step + side) % side;
        around.parts[axis][static_cast<std::size_t>(step + 1)] = cells_.index(there);
      }
    }
    return around;
  }

  /// Pushes sphere i and those in the cells beside its own, row after row; it may have been pushed
  /// into another cell since the row before.
  bool push_from_surroundings(std::int32_t i, double distance) {
    bool overlap = false;
    Surroundings around;
    for (std::size_t y = 0; y < rows_y; ++y) {
      for (std::size_t z = 0; z < rows_z; ++z) {
        const std::int32_t home = home_[static_cast<std::size_t>(i)];
        if (around.home != home) around = surroundings(home);
        std::int32_t row = 0;
        if constexpr (Dim > 1) row += around.parts[y_axis][y];
        if constexpr (Dim > 2) row += around.parts[z_axis][z];
        for (const std::int32_t column : around.parts[0]) {
          overlap |= push_from(i, row + column, distance);
        }
      }
    }
    return overlap;
  }

  /// Pushes sphere i and those of a cell that come after it apart.
  bool push_from(std::int32_t i, std::int32_t cell, double distance) {
    bool overlap = false;
    for (std::int32_t j = lists_.first(cell); j >= 0;) {
      const std::int32_t following = lists_.next(j);  // a push may move j to another cell
      if (j > i && push(i, j, distance)) overlap = true;
      j = following;
    }
    return overlap;
  }

  /// A little more than a push reaches; in a dilute box about two cells for each sphere.
  static double least_width(std::int32_t spheres, const Vec<Dim, double>& sides) {
    double volume = 1;
    for (int axis = 0; axis < Dim; ++axis) volume *= sides[axis];
    const double cells_a_side = std::floor(std::pow(2.0 * spheres, 1.0 / Dim) + 1e-9);
    return std::max(1.01, std::pow(volume, 1.0 / Dim) / std::max(2.0, cells_a_side));
  }

  Vec<Dim, double>& position(std::int32_t i) { return positions_[static_cast<std::size_t>(i)]; }

  std::int32_t cell_of(const Vec<Dim, double>& place) const {
    Steps<Dim> coordinates{};
    for (int axis = 0; axis < Dim; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      coordinates[a] = std::clamp(static_cast<int>(place[axis] / box_.cell_width()[axis]), 0,
                                  box_.cells()[a] - (box_.is_closed(axis) ? 2 : 1));
    }
    return cells_.index(coordinates);
  }

  bool push(std::int32_t i, std::int32_t j, double distance) {
    Vec<Dim, double> dr = position(j) - position(i);
    for (int axis = 0; axis < Dim; ++axis) {
      const double side = box_.sides()[axis];
      if (std::abs(dr[axis]) < side / 2 || box_.is_closed(axis)) continue;
      dr[axis] -= std::copysign(side, dr[axis]);  // both are in the box
    }
    const double r2 = dot(dr, dr);
    if (r2 >= distance * distance) return false;
    const double r = std::sqrt(r2);
    if (r == 0) dr[0] = 1;  // two points on one place: apart along x
    const Vec<Dim, double> step = dr * ((distance - r) / 2 / (r > 0 ? r : 1));
    move(i, step * -1.0);
    move(j, step);
    return r < 1;
  }

  void move(std::int32_t i, const Vec<Dim, double>& step) {
    position(i) += step;
    for (int axis = 0; axis < Dim; ++axis) {
      double& place = position(i)[axis];
      const double side = box_.sides()[axis];
      if (box_.is_closed(axis)) {
        place = std::clamp(place, 0.5, side - 0.5);
      } else {
        place -= side * std::floor(place / side);
        if (!(place < side)) place = 0;
      }
    }
    std::int32_t& home = home_[static_cast<std::size_t>(i)];
    const std::int32_t cell = cell_of(position(i));
    if (cell == home) return;
    lists_.remove(i, home);
    home = cell;
    lists_.insert(i, home);
  }

  ShearBox<Dim, double> box_;
  SlidingCells<Dim> cells_;
  CellLists lists_;
  std::vector<Vec<Dim, double>> positions_;
  std::vector<std::int32_t> home_;
};

}  // namespace

template <int Dim>
std::vector<Vec<Dim, double>> loose_packing(std::int32_t spheres, const ShearBox<Dim, double>& box,
                                            Random& random) {
  if constexpr (Dim == 1) {
    const std::vector<double> lengths(static_cast<std::size_t>(spheres), 1.0);
    return rod_places(lengths, box, random);
  } else {
    constexpr double least_distance = 1.001;  // a little more than needed, so that the sweeps end
    constexpr int most_sweeps = 20000;
    Pushing<Dim> pushing(spheres, box, random);
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
      if (!pushing.sweep(least_distance)) return pushing.positions();
    }
    throw std::invalid_argument("too dense for random places");
  }
}

#define ZENOSPHERE_INSTANTIATE(Dim)                          \
  template std::vector<Vec<Dim, double>> loose_packing<Dim>( \
      std::int32_t, const ShearBox<Dim, double>&, Random&);
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
