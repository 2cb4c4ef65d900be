#include "engine/spheres.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "engine/simd/wide_lanes.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim, class Real>
Spheres<Dim, Real>::Spheres(const ShearBox<Dim, Real>& box, Configuration<Dim, Real> start,
                            const Vector& acceleration)
    : Spheres(HugePageVector<Sphere>(start.positions.size()), std::move(start.grains), box,
              acceleration) {
  assert(start.positions.size() == start.velocities.size());
  assert(start.spins.empty() || start.spins.size() == start.positions.size());
  spins_ = std::move(start.spins);
  sliding_box_.displace_images(start.offset);
  place(start);
}

/// Spheres that are nowhere yet.
template <int Dim, class Real>
Spheres<Dim, Real>::Spheres(HugePageVector<Sphere> spheres, Grains<Real> grains,
                            const ShearBox<Dim, Real>& box, const Vector& acceleration)
    : sliding_box_(box),
      acceleration_(acceleration),
      fall_(!(acceleration == Vector{})),
      some_are_held_(fall_ && !grains.immobile.empty()),
      lanes_are_wide_(!fall_ && has_wide_lanes()),
      grains_(std::move(grains)),
      largest_(grains_.largest_diameter()),
      spheres_(std::move(spheres)),
      boxes_(spheres_.size()) {
  for (const Real& diameter : grains_.diameters) radii_.push_back(diameter / 2);
  require_room();
}

/// Throws std::invalid_argument where a sphere could touch another one beyond the next cell.
template <int Dim, class Real>
void Spheres<Dim, Real>::require_room() const {
  if (are_of_one_size()) return;
  for (int axis = 0; axis < Dim; ++axis) {
    const bool is_alone =
        box().is_closed(axis) && box().cells()[static_cast<std::size_t>(axis)] == 2;
    const Real least = (is_alone ? Real(1) : Real(narrowest_cell)) * largest_;
    if (!(box().cell_width()[axis] >= least)) throw std::invalid_argument("box too narrow");
  }
}

template <int Dim, class Real>
void Spheres<Dim, Real>::place(const Configuration<Dim, Real>& start) {
  using std::floor;
  const Vector width = box().cell_width();
  for (std::int32_t i = 0; i < count(); ++i) {
    Sphere& sphere = (*this)[i];
    const Vector& position = start.positions[static_cast<std::size_t>(i)];
    Steps<Dim> coordinates{};
    for (int axis = 0; axis < Dim; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const int cell = static_cast<int>(floor(static_cast<Real>(position[axis] / width[axis])));
      const int last = box().cells()[a] - (box().is_closed(axis) ? 2 : 1);
      coordinates[a] = std::clamp(cell, 0, last);
    }
    sphere.position = position;
    sphere.cell = cells().index(coordinates);
    sphere.velocity = start.velocities[static_cast<std::size_t>(i)];
    sphere.velocity[0] += sliding_box_.profile_in_layer(sphere.cell, position);
  }
}

template <int Dim, class Real>
Neighbour Spheres<Dim, Real>::nearest_image(std::int32_t i, std::int32_t j,
                                            const Real& when) const {
  const int way = SlidingCells<Dim>::layers(home(j)) - SlidingCells<Dim>::layers(home(i));
  const int layers = SlidingCells<Dim>::layers(cells().cells());
  Neighbour nearest(j, PeriodicImage());
  Real least = std::numeric_limits<Real>::infinity();
  for (std::int32_t code = 0; code < PeriodicImage::count; ++code) {
    const PeriodicImage periodic_image = PeriodicImage::from_code(code);
    if (Dim > 1 && way + periodic_image.periods(1) * layers != periodic_image.layers()) continue;
    const Real square = square_of_distance(i, Neighbour(j, periodic_image), when);
    if (!(square < least)) continue;
    least = square;
    nearest = Neighbour(j, periodic_image);
  }
  return nearest;
}

template <int Dim, class Real>
PeriodicImage Spheres<Dim, Real>::go_home(std::int32_t i, const Real& when, const Vector& ahead) {
  const auto [cell, periodic_image] =
      sliding_box_.home(position_at(i, when) + ahead, (*this)[i].cell, when);
  enter(i, cell, periodic_image);
  return periodic_image;
}

template <int Dim, class Real>
void Spheres<Dim, Real>::shift_times(const Real& span) {
  for (Sphere& sphere : spheres_) sphere.time -= span;
  if (!box().is_sheared()) return;
  sliding_box_.slide_by_one_cell();
  if (Dim == 1 || cells().whole_slide() != 0) return;
  // By a whole box, which is counted from 0 again.
  const int layers = SlidingCells<Dim>::layers(cells().cells());
  for (std::int32_t i = 0; i < count(); ++i) {
    boxes(i)[0] += SlidingCells<Dim>::layers(home(i)) + layers * boxes(i)[Dim > 1 ? 1 : 0];
  }
}

template <int Dim, class Real>
Configuration<Dim, Real> Spheres<Dim, Real>::configuration(double units, const Real& when) const {
  Configuration<Dim, Real> state;
  state.offset = sliding_box_.lees_edwards_offset(units, when);
  state.positions.reserve(spheres_.size());
  state.velocities.reserve(spheres_.size());
  state.boxes.assign(boxes_.begin(), boxes_.end());
  state.grains = grains_;
  state.spins = spins_;
  for (std::size_t i = 0; i < spheres_.size(); ++i) {
    Sphere sphere = copy_at(static_cast<std::int32_t>(i), when);
    Vec<Dim, double>& boxes = state.boxes[i];
    if (!box().is_sheared()) boxes += sliding_box_.bring_back(sphere, sphere.position);
    const auto [cell, periodic_image] = sliding_box_.home(sphere.position, sphere.cell, when);
    if (periodic_image != PeriodicImage()) sliding_box_.see_from(sphere, periodic_image);
    boxes += SlidingBox<Dim, Real>::periods_of(periodic_image);
    sphere.velocity[0] -= sliding_box_.profile_in_layer(cell, sphere.position);
    const int layer = SlidingCells<Dim>::layers(cells().coordinates(cell));
    const auto place = sliding_box_.in_laboratory(sphere.position, layer, boxes, units, when);
    boxes = place.boxes;
    state.positions.push_back(place.in_box);
    state.velocities.push_back(sphere.velocity);
  }
  return state;
}

template <int Dim, class Real>
Spheres<Dim, Real>::Spheres(const Spheres&) = default;
template <int Dim, class Real>
Spheres<Dim, Real>::Spheres(Spheres&&) noexcept = default;
template <int Dim, class Real>
Spheres<Dim, Real>::~Spheres() = default;

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class Spheres<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
