#include "engine/loose_packing.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/sliding_cells.hpp"

namespace zenosphere {

namespace {

/// Points in a periodic cube that are pushed apart until they keep a distance.
template <int Dim>
class Pushing {
 public:
  Pushing(std::int32_t spheres, double side, Random& random)
      : box_(cube(side), 0, least_width(spheres, side)),
        cells_(box_.cells(), false, spheres),
        positions_(static_cast<std::size_t>(spheres)),
        home_(static_cast<std::size_t>(spheres)) {
    for (std::int32_t i = 0; i < spheres; ++i) {
      for (int axis = 0; axis < Dim; ++axis) position(i)[axis] = side * random.uniform();
      home_[static_cast<std::size_t>(i)] = cell_of(position(i));
      cells_.insert(i, home_[static_cast<std::size_t>(i)]);
    }
  }

  /// Pushes every pair closer than `distance` to that distance; returns whether there was one
  /// closer than a diameter.
  bool sweep(double distance) {
    bool overlap = false;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(positions_.size()); ++i) {
      for (const auto& steps : cells_.neighbourhood()) {
        const auto cell = cells_.neighbour(home_[static_cast<std::size_t>(i)], steps).cell;
        for (std::int32_t j = cells_.first(cell); j >= 0;) {
          const std::int32_t following = cells_.next(j);  // a push may move j to another cell
          if (j > i && push(i, j, distance)) overlap = true;
          j = following;
        }
      }
    }
    return overlap;
  }

  const std::vector<Vec<Dim, double>>& positions() const { return positions_; }

 private:
  static Vec<Dim, double> cube(double side) {
    Vec<Dim, double> sides;
    for (int axis = 0; axis < Dim; ++axis) sides[axis] = side;
    return sides;
  }
  static double least_width(std::int32_t spheres, double side) {
    return std::max(1.01, side / std::max(2.0, std::floor(std::cbrt(2.0 * spheres))));
  }

  Vec<Dim, double>& position(std::int32_t i) { return positions_[static_cast<std::size_t>(i)]; }

  std::int32_t cell_of(const Vec<Dim, double>& place) const {
    Steps<Dim> coordinates{};
    for (int axis = 0; axis < Dim; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      coordinates[a] = std::clamp(static_cast<int>(place[axis] / box_.cell_width()[axis]), 0,
                                  box_.cells()[a] - 1);
    }
    return cells_.index(coordinates);
  }

  bool push(std::int32_t i, std::int32_t j, double distance) {
    Vec<Dim, double> dr = position(j) - position(i);
    for (int axis = 0; axis < Dim; ++axis) {
      dr[axis] -= box_.sides()[axis] * std::round(dr[axis] / box_.sides()[axis]);
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
      const double side = box_.sides()[axis];
      position(i)[axis] -= side * std::floor(position(i)[axis] / side);
      if (!(position(i)[axis] < side)) position(i)[axis] = 0;
    }
    std::int32_t& home = home_[static_cast<std::size_t>(i)];
    const std::int32_t cell = cell_of(position(i));
    if (cell == home) return;
    cells_.remove(i, home);
    home = cell;
    cells_.insert(i, home);
  }

  ShearBox<Dim, double> box_;
  SlidingCells<Dim> cells_;
  std::vector<Vec<Dim, double>> positions_;
  std::vector<std::int32_t> home_;
};

}  // namespace

template <int Dim>
std::vector<Vec<Dim, double>> loose_packing(std::int32_t spheres, double side, Random& random) {
  constexpr double kDistance = 1.001;  // a little more than needed, so that the sweeps end
  constexpr int kSweeps = 20000;
  Pushing<Dim> pushing(spheres, side, random);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    if (!pushing.sweep(kDistance)) return pushing.positions();
  }
  throw std::invalid_argument("too dense for random places");
}

template std::vector<Vec<3, double>> loose_packing<3>(std::int32_t, double, Random&);

}  // namespace zenosphere
