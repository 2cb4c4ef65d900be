// Where the spheres are in the laboratory, and how fast: box by box, with the layers that slide.

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/spheres.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

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
Real Spheres<Dim, Real>::lees_edwards_offset(double units, const Real& when) const {
  if constexpr (Dim == 1) return 0;
  using std::floor;
  const Real& side = box_.sides()[0];
  const Real offset = box_.cells()[Dim > 1 ? 1 : 0] * slide(units, when) + offset_;
  return offset - side * floor(static_cast<Real>(offset / side + Real(0.5)));
}

/// Displacement of a layer against the one below it, diameters, up to two whole boxes: half a
/// layer moves by half of it.
template <int Dim, class Real>
Real Spheres<Dim, Real>::slide(double units, const Real& when) const {
  if (!box_.is_sheared()) return 0;
  const auto whole_cells = static_cast<int>(std::fmod(units, 2 * box_.cells()[0]));
  return whole_cells * box_.cell_width()[0] + box_.slide_speed() * when;
}

/// Wraps into the box. Along the gradient and between walls only rounding can lead out, and a
/// wrap would be wrong: such a place is put on the face. Adds the boxes that are taken off.
template <int Dim, class Real>
void Spheres<Dim, Real>::wrap(Vector& position, Vec<Dim, double>& boxes) const {
  using std::floor;
  for (int axis = 0; axis < Dim; ++axis) {
    const Real& side = box_.sides()[axis];
    const Real below = side * (1 - std::numeric_limits<Real>::epsilon());
    if (axis != 1 && !box_.is_closed(axis)) {
      const Real periods = floor(static_cast<Real>(position[axis] / side));
      position[axis] -= side * periods;
      boxes[axis] += static_cast<double>(periods);
    }
    position[axis] = std::clamp(position[axis], Real(0), below);
  }
}

/// The Lees-Edwards offset as the images of the cells have it: not reduced, diameters.
template <int Dim, class Real>
Real Spheres<Dim, Real>::turned_offset(const Real& when) const {
  const Real slide = cells_.whole_slide() * box_.cell_width()[0] + box_.slide_speed() * when;
  return box_.cells()[Dim > 1 ? 1 : 0] * slide + offset_;
}

/// Boxes along x by which a place is further on that slide() puts in a layer: the layers have slid
/// by more than it tells, against each other and, with the middle of the box at rest, all of them.
///
/// \param layer  from 0
template <int Dim, class Real>
double Spheres<Dim, Real>::boxes_slid(double layer, double units) const {
  if (!box_.is_sheared()) return 0;
  const double turns = std::floor(units / box_.cells()[0]);
  const double odd = std::fmod(turns, 2);  // is in slide() already, but not in what turn() counts
  return (1 - box_.cells()[Dim > 1 ? 1 : 0]) * (turns - odd) / 2 - layer * odd;
}

template <int Dim, class Real>
Configuration<Dim, Real> Spheres<Dim, Real>::configuration(double units, const Real& when) const {
  Configuration<Dim, Real> state;
  state.offset = lees_edwards_offset(units, when);
  state.positions.reserve(spheres_.size());
  state.velocities.reserve(spheres_.size());
  state.boxes.assign(boxes_.begin(), boxes_.end());
  state.grains = grains_;
  state.spins = spins_;
  const Real unreduced = Dim > 1 ? turned_offset(when) : Real(0);
  const auto offsets =
      std::round(static_cast<double>(Real(unreduced - state.offset) / box_.sides()[0]));
  for (std::size_t i = 0; i < spheres_.size(); ++i) {
    Sphere sphere = copy_at(static_cast<std::int32_t>(i), when);
    Vec<Dim, double>& boxes = state.boxes[i];
    if (!box_.is_sheared()) boxes += brought_back(sphere, when);
    boxes += periods_of(go_home(sphere, when, {}));
    Vector position = sphere.position;
    if constexpr (Dim > 1) {
      // The frame of layer k moves with its mid-plane; the middle of the box is at rest.
      const int layer = cells_.coordinates(sphere.cell)[1];
      position[0] += (layer + Real(0.5) - box_.cells()[1] / Real(2)) * slide(units, when);
      boxes[0] += boxes_slid(layer, units) + boxes[1] * offsets;
    }
    wrap(position, boxes);
    state.positions.push_back(position);
    state.velocities.push_back(peculiar_velocity(sphere, when));
  }
  return state;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                               \
  template Real Spheres<Dim, Real>::profile_in_layer(const Sphere&, const Real&) const; \
  template Real Spheres<Dim, Real>::lees_edwards_offset(double, const Real&) const;     \
  template Real Spheres<Dim, Real>::turned_offset(const Real&) const;                   \
  template Configuration<Dim, Real> Spheres<Dim, Real>::configuration(double, const Real&) const;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
