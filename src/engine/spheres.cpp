#include "engine/spheres.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "model/instantiate.hpp"
#include "model/walls.hpp"

namespace zenosphere {

template <int Dim, class Real>
Spheres<Dim, Real>::Spheres(const ShearBox<Dim, Real>& box, const Configuration<Dim, Real>& start,
                            const Vector& acceleration)
    : box_(box),
      cells_(box.cells(), box.is_sheared(), static_cast<std::int32_t>(start.positions.size()),
             box.closed_axis()),
      acceleration_(acceleration),
      falls_(!(acceleration == Vector{})),
      spheres_(start.positions.size()) {
  assert(start.positions.size() == start.velocities.size());
  place(start);
}

template <int Dim, class Real>
void Spheres<Dim, Real>::place(const Configuration<Dim, Real>& start) {
  using std::floor;
  const Vector width = box_.cell_width();
  for (std::int32_t i = 0; i < count(); ++i) {
    Sphere& sphere = (*this)[i];
    const Vector& position = start.positions[static_cast<std::size_t>(i)];
    Steps<Dim> coordinates{};
    for (int axis = 0; axis < Dim; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const int cell = static_cast<int>(floor(static_cast<Real>(position[axis] / width[axis])));
      const int last = box_.cells()[a] - (box_.is_closed(axis) ? 2 : 1);
      coordinates[a] = std::clamp(cell, 0, last);
    }
    sphere.position = position;
    sphere.cell = cells_.index(coordinates);
    cells_.insert(i, sphere.cell);
    sphere.velocity = start.velocities[static_cast<std::size_t>(i)];
    sphere.velocity[0] += profile_in_layer(sphere, 0);
  }
}

template <int Dim, class Real>
RelativeMotion<Dim, Real> Spheres<Dim, Real>::motion(std::int32_t i, std::int32_t j,
                                                     const Real& when) const {
  using std::floor;
  const Sphere& a = (*this)[i];
  const Sphere& b = (*this)[j];
  const Vector dr = position_at(b, when) - position_at(a, when);
  const auto image = [&](const Steps<Dim>& way) {
    return box_.image(cells_.lag(a.cell, b.cell, way), cells_.layers(way), when);
  };
  Steps<Dim> steps{};
  for (int axis = Dim - 1; axis >= 0; --axis) {  // layers first: they decide about the columns
    const auto index = static_cast<std::size_t>(axis);
    steps[index] = cells_.steps_between(a.cell, b.cell, axis, cells_.layers(steps));
    if (box_.is_closed(axis)) continue;
    // The way between the spheres may lead around the box: in one of few cells, or after a long
    // flight. Ten thousand periods bound the integers; no gap so long ago has a meaning.
    const Real distance = dr[axis] + image(steps).position[axis];
    const Real periods = floor(static_cast<Real>(distance / box_.sides()[axis] + Real(0.5)));
    steps[index] -=
        box_.cells()[index] * static_cast<int>(std::clamp(periods, Real(-10000), Real(10000)));
  }
  const auto [position, velocity] = image(steps);
  RelativeMotion<Dim, Real> motion{dr + position, velocity_at(b, when) - velocity_at(a, when)};
  motion.dv[0] += velocity;
  return motion;
}

template <int Dim, class Real>
typename Spheres<Dim, Real>::Crossing Spheres<Dim, Real>::next_crossing(
    const Sphere& sphere) const {
  Crossing first{std::numeric_limits<Real>::infinity()};
  for (int axis = 0; axis < Dim; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const int lower = cells_.coordinates(sphere.cell)[a];
    for (const int direction : {-1, 1}) {
      const int face = direction > 0 ? lower + 1 : lower;
      // A closed axis has one empty layer, so that its upper wall is at the last but one face.
      if (box_.is_closed(axis) && (face == 0 || face == box_.cells()[a] - 1)) continue;
      const Real place = face * box_.cell_width()[axis];
      const auto time =
          closing_time<Real>(direction * (place - sphere.position[axis]),
                             -direction * sphere.velocity[axis], -direction * acceleration_[axis]);
      if (time && sphere.time + *time < first.time) first = {sphere.time + *time, axis, direction};
    }
  }
  return first;
}

template <int Dim, class Real>
void Spheres<Dim, Real>::cross(std::int32_t i, const Crossing& crossing, const Real& when) {
  Sphere& sphere = (*this)[i];
  Steps<Dim> steps{};
  steps[static_cast<std::size_t>(crossing.axis)] = crossing.direction;
  if (crossing.axis == 1 && box_.is_sheared()) {
    steps[0] = column_beyond(sphere, crossing.direction, when);
  }
  const auto [cell, lag] = cells_.neighbour(sphere.cell, steps);
  const auto image = box_.image(lag, cells_.layers(steps), when);
  sphere.position -= image.position;
  sphere.velocity[0] -= image.velocity;
  cells_.remove(i, sphere.cell);
  sphere.cell = cell;
  cells_.insert(i, cell);
}

/// The step along x, -1, 0 or 1, at which a sphere arrives in the layer above or below.
template <int Dim, class Real>
int Spheres<Dim, Real>::column_beyond(const Sphere& sphere, int layers, const Real& when) const {
  const Real& width = box_.cell_width()[0];
  const Real slide = layers * (box_.slide_speed() * when);
  const Real from_left = sphere.position[0] - cells_.coordinates(sphere.cell)[0] * width;
  const Real columns = static_cast<Real>((from_left - slide) / width);
  // The slide is below one cell, so that only rounding could lead beyond two columns.
  if (layers > 0) return columns < 0 ? -1 : 0;
  return columns < 1 ? 0 : 1;
}

template <int Dim, class Real>
void Spheres<Dim, Real>::set_back(const Real& span) {
  for (Sphere& sphere : spheres_) sphere.time -= span;
  if (box_.is_sheared()) cells_.slide_by_one_cell();
}

template <int Dim, class Real>
Vec<Dim, Real> Spheres<Dim, Real>::peculiar_velocity(const Sphere& sphere, const Real& when) const {
  Vector velocity = velocity_at(sphere, when);
  velocity[0] -= profile_in_layer(sphere, when);
  return velocity;
}

/// The imposed velocity at the sphere's place, in the frame of its layer.
template <int Dim, class Real>
Real Spheres<Dim, Real>::profile_in_layer(const Sphere& sphere, const Real& when) const {
  if constexpr (Dim == 1) {
    return 0;
  } else {
    if (!box_.is_sheared()) return 0;
    const Real middle = (cells_.coordinates(sphere.cell)[1] + Real(0.5)) * box_.cell_width()[1];
    return box_.shear_rate() * (position_at(sphere, when)[1] - middle);
  }
}

template <int Dim, class Real>
Real Spheres<Dim, Real>::lees_edwards_offset(std::int64_t units, const Real& when) const {
  if constexpr (Dim == 1) return 0;
  using std::floor;
  const Real& side = box_.sides()[0];
  const Real offset = box_.cells()[Dim > 1 ? 1 : 0] * slide(units, when);
  return offset - side * floor(static_cast<Real>(offset / side + Real(0.5)));
}

/// Displacement of a layer against the one below it, diameters, up to two whole boxes: half a
/// layer moves by half of it.
template <int Dim, class Real>
Real Spheres<Dim, Real>::slide(std::int64_t units, const Real& when) const {
  if (!box_.is_sheared()) return 0;
  const auto whole_cells = static_cast<int>(units % (2 * box_.cells()[0]));
  return whole_cells * box_.cell_width()[0] + box_.slide_speed() * when;
}

/// Wraps into the box. Along the gradient and between walls only rounding can lead out, and a
/// wrap would be wrong: such a place is put on the face.
template <int Dim, class Real>
void Spheres<Dim, Real>::wrap(Vector& position) const {
  using std::floor;
  for (int axis = 0; axis < Dim; ++axis) {
    const Real& side = box_.sides()[axis];
    const Real below = side * (1 - std::numeric_limits<Real>::epsilon());
    if (axis != 1 && !box_.is_closed(axis)) {
      position[axis] -= side * floor(static_cast<Real>(position[axis] / side));
    }
    position[axis] = std::clamp(position[axis], Real(0), below);
  }
}

template <int Dim, class Real>
Configuration<Dim, Real> Spheres<Dim, Real>::configuration(std::int64_t units,
                                                           const Real& when) const {
  Configuration<Dim, Real> state;
  state.positions.reserve(spheres_.size());
  state.velocities.reserve(spheres_.size());
  for (const Sphere& sphere : spheres_) {
    Vector position = position_at(sphere, when);
    if constexpr (Dim > 1) {
      // The frame of layer k moves with its mid-plane; the middle of the box is at rest.
      const Real layer = cells_.coordinates(sphere.cell)[1] + Real(0.5) - box_.cells()[1] / Real(2);
      position[0] += layer * slide(units, when);
    }
    wrap(position);
    state.positions.push_back(position);
    state.velocities.push_back(peculiar_velocity(sphere, when));
  }
  return state;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class Spheres<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
