// Spheres that are looked for cell by cell: where they leave their cells, and which they see then.

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "engine/spheres.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

/// From now on spheres are looked for cell by cell: they have to be put into their cells.
template <int Dim, class Real>
void Spheres<Dim, Real>::use_cells() {
  search_.emplace(cells_.cells(), count(),
                  typename CellSearch<Dim>::Slides{box_.is_sheared(), false});
  double widest = 0;
  for (int axis = 0; axis < Dim; ++axis) {
    widest = std::max(widest, static_cast<double>(box_.cell_width()[axis]));
  }
  list_range_.reach = widest / 2;
}

/// From now on there are lists: reference positions are needed.
template <int Dim, class Real>
void Spheres<Dim, Real>::use_lists() {
  search_.reset();
  lists_ = NeighbourLists(count(), list_range_.neighbours);
  if (are_of_one_size()) {
    reference_cells_ = ReferenceCells(cells_.count());
    return;
  }
  std::vector<double> radii;
  for (const Real& radius : radii_) radii.push_back(static_cast<double>(radius));
  const ReferenceGrid<Dim> grid{cell_grains_, list_range_.grain, static_cast<double>(box_.volume()),
                                box_.is_closed(0)};
  sized_cells_.emplace(cells_, grid, radii);
}

/// Where a sphere is at `when`, from the lower corner of its cell.
template <int Dim, class Real>
[[gnu::always_inline]] inline Vec<Dim, Real> Spheres<Dim, Real>::place_in_own_cell(
    const Sphere& sphere, const Real& when) const {
  const Steps<Dim> cell = cells_.coordinates(sphere.cell);
  Vector place = sphere.position + sphere.velocity * (when - sphere.time);
  for (int axis = 0; axis < Dim; ++axis) {
    place[axis] -= cell[static_cast<std::size_t>(axis)] * box_.cell_width()[axis];
  }
  return place;
}

/// The first face ahead of a sphere. Which one it is, is as good as random: a processor would guess
/// wrong at each branch.
///
/// \param in_cell  its place from the lower corner of its cell
template <int Dim, class Real>
[[gnu::always_inline]] inline typename Spheres<Dim, Real>::Exit Spheres<Dim, Real>::exit(
    const Sphere& sphere, const Vector& in_cell) const {
  Real first = std::numeric_limits<Real>::infinity();
  int axis_of_first = 0;
  for (int axis = 0; axis < Dim; ++axis) {
    const Real& speed = sphere.velocity[axis];
    const Real face = box_.cell_width()[axis] * static_cast<int>(speed > 0);
    // Of what rests the time is infinite, or no number: it is not less.
    const Real time = (face - in_cell[axis]) / speed;
    axis_of_first += static_cast<int>(time < first) * (axis - axis_of_first);
    first = time < first ? time : first;
  }
  const bool stays = !(first < std::numeric_limits<Real>::infinity());
  const int direction = sphere.velocity[axis_of_first] > 0 ? 1 : -1;
  return {std::max(Real(0), first), axis_of_first, stays ? 0 : direction};
}

/// When a sphere leaves its cell: of a time after `until` only that it is after it.
template <int Dim, class Real>
Real Spheres<Dim, Real>::exit_at(std::int32_t i, const Real& when, const Real& until) const {
  const Sphere& sphere = (*this)[i];
  const Vector in_cell = place_in_own_cell(sphere, when);
  if constexpr (!std::is_floating_point_v<Real>) {  // dear numbers: mostly there is no need to
                                                    // divide
    const Vector then = in_cell + sphere.velocity * (until - when);
    bool stays = true;
    for (int axis = 0; axis < Dim; ++axis) {
      stays = stays && then[axis] >= 0 && then[axis] <= box_.cell_width()[axis];
    }
    if (stays) return std::numeric_limits<Real>::infinity();
  }
  return when + exit(sphere, in_cell).time;
}

/// Lets a sphere cross the face that it has come to. Its place decides nothing but the column of
/// another layer, and that within those that are seen from here: so rounding leads nowhere else.
///
/// \return  those that it has not seen before
template <int Dim, class Real>
std::span<const Neighbour> Spheres<Dim, Real>::cross_face(std::int32_t i, const Real& when) {
  Sphere& sphere = (*this)[i];
  const Exit exit = this->exit(sphere, place_in_own_cell(sphere, when));
  if (exit.direction == 0) return {};
  const Steps<Dim> from = cells_.coordinates(sphere.cell);
  Steps<Dim> to = from;
  Steps<Dim> periods{};
  const auto a = static_cast<std::size_t>(exit.axis);
  const auto wrap = [&](std::size_t axis) {
    const int cells = box_.cells()[axis];
    for (; to[axis] < 0; to[axis] += cells) --periods[axis];
    for (; to[axis] >= cells; to[axis] -= cells) ++periods[axis];
  };
  const int layers = exit.axis == 1 ? exit.direction : 0;
  to[a] += exit.direction;
  wrap(a);
  if constexpr (Dim > 1) {
    if (layers != 0) {
      to[0] = column_beyond(sphere, from, layers, periods[1], when);
      wrap(0);
    }
  }
  const PeriodicImage periodic_image(periods, layers);
  const std::int32_t cell = cells_.index(to);
  search_->remove(i, from);
  search_->insert(i, to);
  sphere.cell = cell;
  if (periodic_image != PeriodicImage()) {
    see_from(sphere, periodic_image);
    boxes(i) += periods_of(periodic_image);
  }
  const auto fresh = search_->beyond(cells_, {exit.axis, exit.direction, from, to});
  is_crowded_ = is_crowded_ || fresh.size() > most_beyond_face;
  return fresh;
}

/// The column, not wrapped, in which a sphere comes to an adjacent layer.
///
/// \param periods  1 or -1 where that is beyond a face of the box
template <int Dim, class Real>
int Spheres<Dim, Real>::column_beyond(const Sphere& sphere, const Steps<Dim>& from, int layers,
                                      int periods, const Real& when) const {
  using std::floor;
  const int beside = from[0] - layers * cells_.whole_slide() - periods * cells_.whole_offset();
  const auto columns = search_->reach(cells_, from)[static_cast<std::size_t>(layers + 1)];
  const int least = columns.from + 1;
  const int most = columns.to - 1;
  if (least == most) return beside;
  const Real place =
      position_at(sphere, when)[0] - layers * (box_.slide_speed() * when) - periods * offset_;
  const Real column = floor(static_cast<Real>(place / box_.cell_width()[0]));
  const Real step = column - Real(from[0] - periods * cells_.whole_offset());
  if (!(step > Real(least))) return beside + least;
  return beside + (step < Real(most) ? static_cast<int>(step) : most);
}

template <int Dim, class Real>
void Spheres<Dim, Real>::place_anew(std::int32_t i, const Real& when) {
  if (!search_) {
    rebuild_list(i, when, when);
    return;
  }
  Sphere& sphere = (*this)[i];
  search_->remove(i, cells_.coordinates(sphere.cell));
  boxes(i) += periods_of(go_home(sphere, when, {}));
  search_->insert(i, cells_.coordinates(sphere.cell));
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                                        \
  template void Spheres<Dim, Real>::use_cells();                                                 \
  template void Spheres<Dim, Real>::use_lists();                                                 \
  template Real Spheres<Dim, Real>::exit_at(std::int32_t, const Real&, const Real&) const;       \
  template std::span<const Neighbour> Spheres<Dim, Real>::cross_face(std::int32_t, const Real&); \
  template void Spheres<Dim, Real>::place_anew(std::int32_t, const Real&);
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
