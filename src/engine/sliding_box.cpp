#include "engine/sliding_box.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "engine/floor_within.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim, class Real>
SlidingBox<Dim, Real>::SlidingBox(const ShearBox<Dim, Real>& box) : box_(box), cells_(box.cells()) {
  find_images();
}

template <int Dim, class Real>
void SlidingBox<Dim, Real>::displace_images(const Real& offset) {
  using std::floor;
  if (offset == 0) return;
  assert(Dim > 1 && !box_.is_closed(0) && !box_.is_closed(1));
  offset_ = offset;
  const Real columns = offset / box_.cell_width()[0];
  const Real whole = floor(columns);
  cells_.displace_images(static_cast<int>(whole));
  odd_offset_ = static_cast<double>(Real(columns - whole));
  find_images();
}

template <int Dim, class Real>
void SlidingBox<Dim, Real>::slide_by_one_cell() {
  cells_.slide_by_one_cell();
  find_images();
}

template <int Dim, class Real>
void SlidingBox<Dim, Real>::slide_to(int whole_cells) {
  cells_.slide_to(whole_cells);
  find_images();
}

template <int Dim, class Real>
void SlidingBox<Dim, Real>::find_images() {
  for (std::int32_t code = 0; code < PeriodicImage::count; ++code) {
    const PeriodicImage periodic_image = PeriodicImage::from_code(code);
    Steps<Dim> lag{};
    for (int axis = 0; axis < Dim; ++axis) {
      lag[static_cast<std::size_t>(axis)] =
          periodic_image.periods(axis) * box_.cells()[static_cast<std::size_t>(axis)];
    }
    lag[0] += periodic_image.layers() * cells_.whole_slide();
    Image<Dim, Real>& image = images_[static_cast<std::size_t>(code)];
    image = box_.image(lag, periodic_image.layers(), 0);
    if constexpr (Dim > 1) image.position[0] += periodic_image.periods(1) * offset_;
  }
}

template <int Dim, class Real>
typename SlidingBox<Dim, Real>::Home SlidingBox<Dim, Real>::home(const Vector& position,
                                                                 std::int32_t from,
                                                                 const Real& when) const {
  const Vector& width = box_.cell_width();
  const Steps<Dim> old = cells_.coordinates(from);
  Steps<Dim> home{};
  Steps<Dim> periods{};
  int layers = 0;
  for (int axis = Dim - 1; axis >= 0; --axis) {  // the layer first: it decides about the column
    const auto a = static_cast<std::size_t>(axis);
    const int cells = box_.cells()[a];
    Real place = position[axis];
    if (axis == 0) {
      place -= layers * (box_.slide_speed() * when);
      if constexpr (Dim > 1) place -= periods[1] * offset_;
    }
    const int farthest = axis == 0 ? 2 : 1;  // boxes
    int cell =
        floor_within(-farthest * cells, (1 + farthest) * cells - 1, Real(place / width[axis]));
    if (axis == 0) cell -= layers * cells_.whole_slide();
    if (box_.is_closed(axis)) cell = std::clamp(cell, 0, cells - 2);
    periods[a] = cell < 0 ? -1 : cell >= cells ? 1 : 0;
    if (axis == 0) {
      periods[a] += (cell >= 2 * cells) - (cell < -cells);
      periods[a] += (cell >= 3 * cells) - (cell < -2 * cells);
    }
    home[a] = std::clamp(cell - periods[a] * cells, 0, cells - 1);
    if (axis == 1) layers = std::clamp(cell - old[a], -1, 1);
  }
  return {cells_.index(home), PeriodicImage(periods, layers)};
}

template <int Dim, class Real>
void SlidingBox<Dim, Real>::see_from(Sphere& sphere, PeriodicImage periodic_image) const {
  const Image<Dim, Real>& image = this->image(periodic_image);
  sphere.position -= image.position;
  sphere.position[0] -= image.velocity * sphere.time;
  sphere.velocity[0] -= image.velocity;
}

template <int Dim, class Real>
Vec<Dim, double> SlidingBox<Dim, Real>::bring_back(Sphere& sphere, const Vector& place) const {
  using std::floor;
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
LayerSlides SlidingBox<Dim, Real>::slides(const Steps<Dim>& home, const Real& when) const {
  double slid = 0;
  if (box_.is_sheared()) {
    slid = std::clamp(static_cast<double>(when / box_.clock_unit()), 0.0, 1.0);
  }
  LayerSlides slides{slid, slid};
  if constexpr (Dim > 1) {
    if (home[1] == 0) slides.below += odd_offset_;
    if (home[1] + 1 == box_.cells()[1]) slides.above += odd_offset_;
  }
  return slides;
}

template <int Dim, class Real>
Vec<Dim, Real> SlidingBox<Dim, Real>::shortest_image(Vector displacement, const Real& when) const {
  using std::floor;
  for (int axis = Dim - 1; axis >= 0; --axis) {  // layers first: they decide about the columns
    if (box_.is_closed(axis)) continue;
    const Real& side = box_.sides()[axis];
    const Real half = side / 2;
    if (-half < displacement[axis] && displacement[axis] < half) continue;
    const Real periods = floor(static_cast<Real>(displacement[axis] / side + Real(0.5)));
    displacement[axis] -= periods * side;
    if (axis == 1) {
      displacement[0] -= periods * turned_offset(when);
    }
  }
  return displacement;
}

template <int Dim, class Real>
Real SlidingBox<Dim, Real>::lees_edwards_offset(double units, const Real& when) const {
  if constexpr (Dim == 1) return 0;
  using std::floor;
  const Real& side = box_.sides()[0];
  const Real offset = box_.cells()[Dim > 1 ? 1 : 0] * slide(units, when) + offset_;
  return offset - side * floor(static_cast<Real>(offset / side + Real(0.5)));
}

/// Displacement of a layer against the one below it, diameters, up to two whole boxes: half a
/// layer moves by half of it.
template <int Dim, class Real>
Real SlidingBox<Dim, Real>::slide(double units, const Real& when) const {
  if (!box_.is_sheared()) return 0;
  const auto whole_cells = static_cast<int>(std::fmod(units, 2 * box_.cells()[0]));
  return whole_cells * box_.cell_width()[0] + box_.slide_speed() * when;
}

/// The Lees-Edwards offset as the images of the cells have it: not reduced, diameters.
template <int Dim, class Real>
Real SlidingBox<Dim, Real>::turned_offset(const Real& when) const {
  const Real slide = cells_.whole_slide() * box_.cell_width()[0] + box_.slide_speed() * when;
  return box_.cells()[Dim > 1 ? 1 : 0] * slide + offset_;
}

/// Boxes along x by which a place is further on that slide() puts in a layer: the layers have slid
/// by more than it tells, against each other and, with the middle of the box at rest, all of them.
template <int Dim, class Real>
double SlidingBox<Dim, Real>::boxes_slid(double layer, double units) const {
  if (!box_.is_sheared()) return 0;
  const double turns = std::floor(units / box_.cells()[0]);
  // Is in slide() already, but not in what is counted where the slide begins from 0 again.
  const double odd = std::fmod(turns, 2);
  return (1 - box_.cells()[Dim > 1 ? 1 : 0]) * (turns - odd) / 2 - layer * odd;
}

template <int Dim, class Real>
typename SlidingBox<Dim, Real>::Place SlidingBox<Dim, Real>::in_laboratory(Vector place, int layer,
                                                                           Vec<Dim, double> boxes,
                                                                           double units,
                                                                           const Real& when) const {
  Place there{place, boxes};
  if constexpr (Dim > 1) {
    // The frame of layer k moves with its mid-plane; the middle of the box is at rest.
    there.in_box[0] += (layer + Real(0.5) - box_.cells()[1] / Real(2)) * slide(units, when);
    const Real reduced = turned_offset(when) - lees_edwards_offset(units, when);
    const auto offsets = std::round(static_cast<double>(Real(reduced / box_.sides()[0])));
    there.boxes[0] += boxes_slid(layer, units) + boxes[1] * offsets;
  }
  wrap(there);
  return there;
}

/// Wraps into the box. Along the gradient and between walls only rounding can lead out, and a
/// wrap would be wrong: such a place is put on the face. Adds the boxes that are taken off.
template <int Dim, class Real>
void SlidingBox<Dim, Real>::wrap(Place& place) const {
  using std::floor;
  for (int axis = 0; axis < Dim; ++axis) {
    Real& here = place.in_box[axis];
    const Real& side = box_.sides()[axis];
    const Real below = side * (1 - std::numeric_limits<Real>::epsilon());
    if (axis != 1 && !box_.is_closed(axis)) {
      const Real periods = floor(static_cast<Real>(here / side));
      here -= side * periods;
      place.boxes[axis] += static_cast<double>(periods);
    }
    here = std::clamp(here, Real(0), below);
  }
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class SlidingBox<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
