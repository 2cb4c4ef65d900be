// When and where neighbour lists are rebuilt.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/spheres.hpp"
#include "model/instantiate.hpp"
#include "model/walls.hpp"

namespace zenosphere {

namespace {

/// The floor of a number, from `least` to `most` whatever it is: in a state that has been made
/// up it may be anything.
template <class Real>
int floor_within(int least, int most, const Real& number) {
  using std::floor;
  if (!(number > least)) return least;
  return number < most ? static_cast<int>(floor(number)) : most;
}

}  // namespace

template <int Dim, class Real>
Real Spheres<Dim, Real>::rebuild_time(std::int32_t i, const Real& when, const Real& until) const {
  if (search_) return exit_at(i, when, until);
  const Sphere& sphere = (*this)[i];
  const ReferencePosition& reference = this->reference(i);
  const Vector corner = this->corner(sphere.cell);
  const Vector place = position_at(sphere, when);
  const Vector velocity = velocity_at(sphere, when);
  Vector away;
  for (int axis = 0; axis < Dim; ++axis) {
    const Real middle = reference.place[static_cast<std::size_t>(axis)] * Real(list_range_.grain);
    away[axis] = (place[axis] - corner[axis]) - middle;
  }
  const Real expires = static_cast<Real>(double{reference.expires} * list_range_.expiry_unit);
  if (!falls_) {
    // Most spheres meet another one before they leave their ball: that needs no root.
    const Vector then = away + velocity * (until - when);
    const Real reach = Real(list_range_.reach);
    if (dot(then, then) < reach * reach) return expires;
  }
  const Real left =
      when + (falls_ ? time_in_cube(away, velocity, pull(sphere)) : time_in_ball(away, velocity));
  return left < expires ? left : expires;
}

/// Time until a sphere that flies straight is `list_range_.reach` away from its reference position.
///
/// \param away  its place relative to the reference position
template <int Dim, class Real>
Real Spheres<Dim, Real>::time_in_ball(const Vector& away, const Vector& velocity) const {
  using std::sqrt;
  const Real v2 = dot(velocity, velocity);
  if (!(v2 > 0)) return std::numeric_limits<Real>::infinity();
  const Real b = dot(away, velocity);
  const Real room = Real(list_range_.reach) * Real(list_range_.reach) - dot(away, away);
  if (!(room > 0)) return 0;  // outside already, by rounding
  const Real root = sqrt(b * b + v2 * room);
  if (!(root > 0)) return std::numeric_limits<Real>::infinity();  // too slow for the exponent
  return b > 0 ? room / (b + root) : (root - b) / v2;
}

/// Time until a falling sphere leaves the cube inside that ball.
template <int Dim, class Real>
Real Spheres<Dim, Real>::time_in_cube(const Vector& away, const Vector& velocity,
                                      const Vector& pull) const {
  const Real half = Real(reach_along_axes());
  Real first = std::numeric_limits<Real>::infinity();
  for (int axis = 0; axis < Dim; ++axis) {
    for (const int direction : {-1, 1}) {
      const auto time = closing_time<Real>(half - direction * away[axis],
                                           -direction * velocity[axis], -direction * pull[axis]);
      if (time && *time < first) first = *time;
    }
  }
  return first;
}

template <int Dim, class Real>
std::span<const Neighbour> Spheres<Dim, Real>::rebuild_list(std::int32_t i, const Real& when,
                                                            const Real& meeting) {
  if (search_) return cross_face(i, when);
  Sphere& sphere = (*this)[i];
  remove_reference(i);
  const Vector ahead = displacement_of_reference(velocity_at(sphere, when), meeting - when);
  // Every image may lie elsewhere now. In a narrow box, with several images of one neighbour, one
  // that is known could pass for another one that is new.
  const PeriodicImage periodic_image = go_home(sphere, when, ahead);
  const bool is_seen_anew = periodic_image != PeriodicImage();
  const Vec<Dim, double> periods = periods_of(periodic_image);
  if (periods != Vec<Dim, double>{}) boxes(i) += periods;
  const NeighbourLists::Changes all_gone{};
  const bool is_worth_prefetching = count() > most_spheres_in_cache;
  if (is_seen_anew && is_worth_prefetching) lists_.prefetch(i, {}, all_gone);
  put_reference(i, when, ahead);
  const std::span<Neighbour> neighbours = neighbours_of(i, when);
  if (is_seen_anew) lists_.replace(i, {}, all_gone);
  const NeighbourLists::Changes changes = lists_.changes(i, neighbours);
  const std::span<const Neighbour> fresh = neighbours.first(changes.fresh);
  if (is_worth_prefetching) {
    for (const Neighbour neighbour : fresh) prefetch_line(&(*this)[neighbour.sphere()]);
    lists_.prefetch(i, neighbours, changes);
  }
  lists_.replace(i, neighbours, changes);
  insert_reference(i);
  is_crowded_ = is_crowded_ || (list_range_.is_wide && neighbours.size() > most_alone);
  // What looks at four at once looks beyond the end: at none for which it would have to wait.
  if (!fresh.empty()) std::fill_n(nearby_.data() + changes.fresh, 3, fresh.back());
  return fresh;
}

/// How far ahead of a sphere its reference position lies. In a dilute system that is where it is
/// going to meet another one, unless it leaves its ball before: it flies straight until then, and
/// stays in the ball up to twice as long as if that were around the place where its list is
/// rebuilt.
///
/// \param flight  time until the meeting; infinity: there is none
template <int Dim, class Real>
Vec<Dim, Real> Spheres<Dim, Real>::displacement_of_reference(const Vector& velocity,
                                                             const Real& flight) const {
  using std::sqrt;
  if (!list_range_.is_dilute) return {};
  constexpr double share = 0.9;  // of the way to the edge, which rounding must not take it over
  const Real v2 = dot(velocity, velocity);
  if (!(v2 > 0)) return {};
  const Real longest = Real(share * (falls_ ? reach_along_axes() : list_range_.reach)) / sqrt(v2);
  return velocity * std::clamp(flight, Real(0), longest);
}

/// \param ahead  from where the sphere is at `when` to its reference position
template <int Dim, class Real>
void Spheres<Dim, Real>::put_reference(std::int32_t i, const Real& when, const Vector& ahead) {
  reference(i).place = place_in_cell(position_at((*this)[i], when) + ahead, (*this)[i].cell);
  reference(i).expires = static_cast<float>((static_cast<double>(when) + list_range_.window) /
                                            list_range_.expiry_unit);
}

/// A place from the lower corner of a cell, in grains.
template <int Dim, class Real>
ReferencePosition::Place Spheres<Dim, Real>::place_in_cell(const Vector& place,
                                                           std::int32_t cell) const {
  const Vector corner = this->corner(cell);
  ReferencePosition::Place in_cell{};
  for (int axis = 0; axis < Dim; ++axis) {
    const double grains = static_cast<double>(place[axis] - corner[axis]) / list_range_.grain;
    in_cell[static_cast<std::size_t>(axis)] =
        static_cast<std::int16_t>(floor_within(0, ReferenceCells::grains_a_cell, grains + 0.5));
  }
  return in_cell;
}

/// The lower corner of a cell.
template <int Dim, class Real>
Vec<Dim, Real> Spheres<Dim, Real>::corner(std::int32_t cell) const {
  const Steps<Dim> coordinates = cells_.coordinates(cell);
  Vector corner;
  for (int axis = 0; axis < Dim; ++axis) {
    corner[axis] = coordinates[static_cast<std::size_t>(axis)] * box_.cell_width()[axis];
  }
  return corner;
}

/// Gives a sphere the cell of the place `ahead` of where it is at `when`, and the frame of that
/// cell's layer. It stays stored for the time for which it was: only where it is given another
/// layer or image of the box is it rounded.
///
/// \return  the periodic image in which that is seen
template <int Dim, class Real>
PeriodicImage Spheres<Dim, Real>::go_home(Sphere& sphere, const Real& when,
                                          const Vector& ahead) const {
  const Vector position = position_at(sphere, when) + ahead;
  const Vector& width = box_.cell_width();
  const Steps<Dim> old = cells_.coordinates(sphere.cell);
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
  sphere.cell = cells_.index(home);
  const PeriodicImage periodic_image(periods, layers);
  if (periodic_image != PeriodicImage()) see_from(sphere, periodic_image);
  return periodic_image;
}

/// Gives a sphere the frame and the box of a periodic image.
template <int Dim, class Real>
void Spheres<Dim, Real>::see_from(Sphere& sphere, PeriodicImage periodic_image) const {
  const Image<Dim, Real>& image = this->image(periodic_image);
  sphere.position -= image.position;
  sphere.position[0] -= image.velocity * sphere.time;
  sphere.velocity[0] -= image.velocity;
}

template <int Dim, class Real>
void Spheres<Dim, Real>::shift_times(const Real& span) {
  for (Sphere& sphere : spheres_) sphere.time -= span;
  if (!box_.is_sheared()) return;
  const auto units = static_cast<float>(static_cast<double>(span) / list_range_.expiry_unit);
  if (!search_) {
    for (std::int32_t i = 0; i < count(); ++i) reference(i).expires -= units;
  }
  cells_.slide_by_one_cell();
  if (cells_.whole_slide() == 0) turn();
  find_images();
}

/// The layers have slid by a whole box, which is counted from 0 again.
template <int Dim, class Real>
void Spheres<Dim, Real>::turn() {
  if (!search_) lists_.turn();
  if constexpr (Dim > 1) {
    for (std::int32_t i = 0; i < count(); ++i) {
      const int layer = cells_.coordinates((*this)[i].cell)[1];
      boxes(i)[0] += layer + box_.cells()[1] * boxes(i)[1];
    }
  }
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                                         \
  template Real Spheres<Dim, Real>::rebuild_time(std::int32_t, const Real&, const Real&) const;   \
  template std::span<const Neighbour> Spheres<Dim, Real>::rebuild_list(std::int32_t, const Real&, \
                                                                       const Real&);              \
  template void Spheres<Dim, Real>::put_reference(std::int32_t, const Real&,                      \
                                                  const Vec<Dim, Real>&);                         \
  template ReferencePosition::Place Spheres<Dim, Real>::place_in_cell(const Vec<Dim, Real>&,      \
                                                                      std::int32_t) const;        \
  template Vec<Dim, Real> Spheres<Dim, Real>::corner(std::int32_t) const;                         \
  template PeriodicImage Spheres<Dim, Real>::go_home(Sphere&, const Real&, const Vec<Dim, Real>&) \
      const;                                                                                      \
  template void Spheres<Dim, Real>::see_from(Sphere&, PeriodicImage) const;                       \
  template void Spheres<Dim, Real>::shift_times(const Real&);
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
