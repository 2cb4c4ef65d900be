#include "engine/search_by_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "engine/list_range.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim, class Real>
SearchByCells<Dim, Real>::SearchByCells(const Spheres<Dim, Real>& spheres)
    : search_(spheres.cells().cells(), spheres.count(),
              {spheres.box().is_sheared(), spheres.sliding_box().has_displaced_images()}) {
  double widest = 0;
  for (int axis = 0; axis < Dim; ++axis) {
    widest = std::max(widest, static_cast<double>(spheres.box().cell_width()[axis]));
  }
  reach_ = widest / 2;
  for (std::int32_t i = 0; i < spheres.count(); ++i) search_.insert(i, spheres.home(i));
}

template <int Dim, class Real>
Neighbour SearchByCells<Dim, Real>::neighbour(const Spheres<Dim, Real>& spheres, std::int32_t i,
                                              std::int32_t j, const Real& when) const {
  const auto periodic_image =
      search_.periodic_image(spheres.cells(), spheres.home(i), spheres.home(j));
  return periodic_image ? Neighbour(j, *periodic_image) : spheres.nearest_image(i, j, when);
}

/// Where a sphere is at `when`, from the lower corner of its cell.
template <int Dim, class Real>
[[gnu::always_inline]] inline Vec<Dim, Real> SearchByCells<Dim, Real>::place_in_cell(
    const Spheres<Dim, Real>& spheres, std::int32_t i, const Real& when) const {
  const auto& sphere = spheres[i];
  const Steps<Dim> cell = spheres.home(i);
  Vector place = sphere.position + sphere.velocity * (when - sphere.time);  // none falls
  for (int axis = 0; axis < Dim; ++axis) {
    place[axis] -= cell[static_cast<std::size_t>(axis)] * spheres.box().cell_width()[axis];
  }
  return place;
}

/// The first face ahead of a sphere. Which one it is, is as good as random: at each branch a
/// processor would guess wrong.
///
/// \param in_cell  its place from the lower corner of its cell
template <int Dim, class Real>
[[gnu::always_inline]] inline typename SearchByCells<Dim, Real>::Exit
SearchByCells<Dim, Real>::exit(const Spheres<Dim, Real>& spheres, std::int32_t i,
                               const Vector& in_cell) const {
  const Vector& velocity = spheres[i].velocity;
  Real first = std::numeric_limits<Real>::infinity();
  int axis_of_first = 0;
  for (int axis = 0; axis < Dim; ++axis) {
    const Real face = spheres.box().cell_width()[axis] * static_cast<int>(velocity[axis] > 0);
    const Real time = (face - in_cell[axis]) / velocity[axis];  // of what rests it is no time
    const bool is_first = (time < first) & (velocity[axis] != 0);
    axis_of_first += static_cast<int>(is_first) * (axis - axis_of_first);
    first = is_first ? time : first;
  }
  const bool stays = !(first < std::numeric_limits<Real>::infinity());
  const int direction = velocity[axis_of_first] > 0 ? 1 : -1;
  return {std::max(Real(0), first), axis_of_first, stays ? 0 : direction};
}

template <int Dim, class Real>
Real SearchByCells<Dim, Real>::renewal_time(const Spheres<Dim, Real>& spheres, std::int32_t i,
                                            const Real& when, const Real& until) const {
  const Vector in_cell = place_in_cell(spheres, i, when);
  if constexpr (!std::is_floating_point_v<Real>) {  // dear numbers: most need no division
    const Vector then = in_cell + spheres[i].velocity * (until - when);
    bool stays = true;
    for (int axis = 0; axis < Dim; ++axis) {
      stays = stays && then[axis] >= 0 && then[axis] <= spheres.box().cell_width()[axis];
    }
    if (stays) return std::numeric_limits<Real>::infinity();
  }
  return when + exit(spheres, i, in_cell).time;
}

/// Its place decides nothing but the column of another layer, and that within those that are seen
/// from here: so rounding leads nowhere else.
template <int Dim, class Real>
std::span<const Neighbour> SearchByCells<Dim, Real>::renew(Spheres<Dim, Real>& spheres,
                                                           std::int32_t i, const Real& when,
                                                           const Real& /*meeting*/) {
  const SlidingCells<Dim>& cells = spheres.cells();
  const Exit exit = this->exit(spheres, i, place_in_cell(spheres, i, when));
  if (exit.direction == 0) return {};
  const Steps<Dim> from = spheres.home(i);
  Steps<Dim> to = from;
  Steps<Dim> periods{};
  const auto a = static_cast<std::size_t>(exit.axis);
  const auto wrap = [&](std::size_t axis) {
    const int count = cells.cells()[axis];
    for (; to[axis] < 0; to[axis] += count) --periods[axis];
    for (; to[axis] >= count; to[axis] -= count) ++periods[axis];
  };
  const int layers = exit.axis == 1 ? exit.direction : 0;
  to[a] += exit.direction;
  wrap(a);
  if constexpr (Dim > 1) {
    if (layers != 0) {
      to[0] = column_beyond(spheres, i, layers, periods[1], when);
      wrap(0);
    }
  }
  search_.remove(i, from);
  search_.insert(i, to);
  spheres.enter(i, cells.index(to), PeriodicImage(periods, layers));
  const auto fresh = search_.beyond(cells, {exit.axis, exit.direction, from, to});
  is_crowded_ = is_crowded_ || fresh.size() > most_beyond_face;
  return fresh;
}

/// The column, not wrapped, in which a sphere comes to an adjacent layer.
///
/// \param periods  1 or -1 where that is beyond a face of the box
template <int Dim, class Real>
int SearchByCells<Dim, Real>::column_beyond(const Spheres<Dim, Real>& spheres, std::int32_t i,
                                            int layers, int periods, const Real& when) const {
  using std::floor;
  const SlidingCells<Dim>& cells = spheres.cells();
  const Steps<Dim> from = spheres.home(i);
  const int beside = from[0] - layers * cells.whole_slide() - periods * cells.whole_offset();
  const auto columns = search_.reach(cells, from)[static_cast<std::size_t>(layers + 1)];
  const int least = columns.from + 1;
  const int most = columns.to - 1;
  if (least == most) return beside;
  const Real place = spheres.position_at(i, when)[0] -
                     layers * (spheres.box().slide_speed() * when) -
                     periods * spheres.sliding_box().offset();
  const Real column = floor(static_cast<Real>(place / spheres.box().cell_width()[0]));
  const Real step = column - Real(from[0] - periods * cells.whole_offset());
  if (!(step > Real(least))) return beside + least;
  return beside + (step < Real(most) ? static_cast<int>(step) : most);
}

template <int Dim, class Real>
void SearchByCells<Dim, Real>::place_anew(Spheres<Dim, Real>& spheres, std::int32_t i,
                                          const Real& when) {
  search_.remove(i, spheres.home(i));
  spheres.go_home(i, when, {});
  search_.insert(i, spheres.home(i));
}

template <int Dim, class Real>
void SearchByCells<Dim, Real>::prefetch_around(const Spheres<Dim, Real>& spheres, std::int32_t i,
                                               const Real& /*when*/) const {
  search_.prefetch(spheres.cells(), spheres.home(i));
}

template <int Dim, class Real>
Vec<Dim, Real> SearchByCells<Dim, Real>::from_middle(const Spheres<Dim, Real>& spheres,
                                                     std::int32_t i, const Vector& place) const {
  const Vector corner = spheres.sliding_box().corner(spheres[i].cell);
  Vector away;
  for (int axis = 0; axis < Dim; ++axis) {
    away[axis] = (place[axis] - corner[axis]) - Real(spheres.box().cell_width()[axis] / 2);
  }
  return away;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class SearchByCells<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
