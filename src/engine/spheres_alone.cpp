// Spheres that are far apart: that meet no other for long, and balls as wide as cells until a crowd
// comes together.

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/spheres.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim, class Real>
bool Spheres<Dim, Real>::is_far_out(std::int32_t i, const Real& when) const {
  const Vector place = position_at((*this)[i], when);
  const Vector corner = this->corner((*this)[i].cell);
  Vector away;
  for (int axis = 0; axis < Dim; ++axis) {
    const Real middle =
        search_
            ? Real(box_.cell_width()[axis] / 2)
            : Real(reference(i).place[static_cast<std::size_t>(axis)] * Real(list_range_.grain));
    away[axis] = (place[axis] - corner[axis]) - middle;
  }
  const Real limit = 2 * Real(list_range_.reach);
  return dot(away, away) > limit * limit;
}

/// \return  through how many boxes it has come
template <int Dim, class Real>
Vec<Dim, double> Spheres<Dim, Real>::brought_back(Sphere& sphere, const Real& when) const {
  using std::floor;
  const Vector place = position_at(sphere, when);
  Vec<Dim, double> boxes;
  Real displaced = 0;
  for (int axis = Dim - 1; axis >= 0; --axis) {  // y before x, along which it displaces the images
    const Real& side = box_.sides()[axis];
    const Real here = axis == 0 ? Real(place[0] - displaced) : place[axis];
    if (box_.is_closed(axis) || (here > -side && here < 2 * side)) continue;
    const Real periods = floor(static_cast<Real>(here / side));
    boxes[axis] = static_cast<double>(periods);
    sphere.position[axis] -= side * periods;
    if (axis == 1) displaced = periods * offset_;
  }
  sphere.position[0] -= displaced;
  return boxes;
}

template <int Dim, class Real>
bool Spheres<Dim, Real>::is_crowd_in_a_cell() const {
  std::vector<std::int32_t> spheres(static_cast<std::size_t>(cells_.count()));
  const auto is_crowd = [&](const Sphere& sphere) {
    return ++spheres[static_cast<std::size_t>(sphere.cell)] > most_alone;
  };
  return std::any_of(spheres_.begin(), spheres_.end(), is_crowd);
}

template <int Dim, class Real>
bool Spheres<Dim, Real>::share_layer(std::int32_t i, std::int32_t j) const {
  const auto layer = [&](std::int32_t k) {
    return SlidingCells<Dim>::layers(cells_.coordinates((*this)[k].cell));
  };
  return layer(i) == layer(j);
}

template <int Dim, class Real>
void Spheres<Dim, Real>::rebuild_in_crowd(const Real& when) {
  list_range_ = list_range_in_crowd(box_, count(), sizes_of(grains_));
  is_crowded_ = false;
  if (search_) {
    use_lists();
    for (std::int32_t i = 0; i < count(); ++i) {
      put_reference(i, when, {});
      insert_reference(i);
    }
  }
  for (std::int32_t i = 0; i < count(); ++i) rebuild_list(i, when, when);
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                                 \
  template bool Spheres<Dim, Real>::is_far_out(std::int32_t, const Real&) const;          \
  template Vec<Dim, double> Spheres<Dim, Real>::brought_back(Sphere&, const Real&) const; \
  template bool Spheres<Dim, Real>::is_crowd_in_a_cell() const;                           \
  template bool Spheres<Dim, Real>::share_layer(std::int32_t, std::int32_t) const;        \
  template void Spheres<Dim, Real>::rebuild_in_crowd(const Real&);
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
