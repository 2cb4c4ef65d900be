#include "engine/search_by_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <type_traits>

#include "engine/list_range.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim, class Real>
SearchByCells<Dim, Real>::SearchByCells(const Spheres<Dim, Real>& spheres)
    : search_(spheres.cells().cells(), spheres.count(),
              {spheres.box().is_sheared(), spheres.sliding_box().has_displaced_images()}),
      exits_(static_cast<std::size_t>(spheres.count())) {
  double widest = 0;
  for (int axis = 0; axis < Dim; ++axis) {
    const Real& width = spheres.box().cell_width()[axis];
    widths_[static_cast<std::size_t>(axis)] = width;
    widest = std::max(widest, static_cast<double>(width));
  }
  reach_ = widest / 2;
  for (std::int32_t i = 0; i < spheres.count(); ++i) search_.insert(i, spheres.home(i));
}

template <int Dim, class Real>
SearchByCells<Dim, Real>::SearchByCells(const Spheres<Dim, Real>& spheres, ArchiveReader& archive)
    : SearchByCells(spheres) {
  archive(exits_);
  require_archived(exits_.size() == static_cast<std::size_t>(spheres.count()),
                   "faces of another number of spheres");
  for (const std::int8_t exit : exits_) {
    require_archived(exit >= -Dim && exit <= Dim, "a face that there is not");
  }
}

template <int Dim, class Real>
Neighbour SearchByCells<Dim, Real>::neighbour(const Spheres<Dim, Real>& spheres, std::int32_t i,
                                              std::int32_t j, const Real& when) const {
  const auto periodic_image =
      search_.periodic_image(spheres.cells(), spheres.home(i), spheres.home(j));
  return periodic_image ? Neighbour(j, *periodic_image) : spheres.nearest_image(i, j, when);
}

template <int Dim, class Real>
[[gnu::always_inline]] inline NextFace<Real> SearchByCells<Dim, Real>::next_face(
    const Spheres<Dim, Real>& spheres, std::int32_t i, const Real& when) const {
  if constexpr (std::is_same_v<Real, double>) {
    if (lanes_are_wide_) return next_face_wide<Dim>(spheres[i], spheres.home(i), widths_, when);
  }
  return zenosphere::next_face<Dim>(spheres[i], spheres.home(i), widths_, when);
}

template <int Dim, class Real>
Real SearchByCells<Dim, Real>::plan_renewal(const Spheres<Dim, Real>& spheres, std::int32_t i,
                                            const Real& when, const Real& until) {
  std::int8_t& exit = exits_[static_cast<std::size_t>(i)];
  if constexpr (!std::is_floating_point_v<Real>) {  // dear numbers: most need no division
    const Steps<Dim> cell = spheres.home(i);
    const Vector then = spheres.position_at(i, until);
    bool stays = true;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const Real in_cell = then[static_cast<int>(axis)] - cell[axis] * widths_[axis];
      stays = stays && in_cell >= 0 && in_cell <= widths_[axis];
    }
    if (stays) {
      exit = 0;
      return std::numeric_limits<Real>::infinity();
    }
  }
  const NextFace<Real> next = next_face(spheres, i, when);
  exit = static_cast<std::int8_t>(next.direction * (next.axis + 1));
  return when + next.time;
}

/// Which face it is, is known beforehand: a processor that has to wait for it guesses wrong.
/// Its place decides nothing but the column of another layer, and that within those that are seen
/// from here: so rounding leads nowhere else.
template <int Dim, class Real>
std::span<const Neighbour> SearchByCells<Dim, Real>::renew(Spheres<Dim, Real>& spheres,
                                                           std::int32_t i, const Real& when,
                                                           const Real& /*meeting*/) {
  const SlidingCells<Dim>& cells = spheres.cells();
  const int exit = exits_[static_cast<std::size_t>(i)];
  if (exit == 0) return {};
  const int axis = std::abs(exit) - 1;
  const int direction = exit > 0 ? 1 : -1;
  const Steps<Dim> from = spheres.home(i);
  Steps<Dim> to = from;
  Steps<Dim> periods{};
  const auto a = static_cast<std::size_t>(axis);
  const auto wrap = [&](std::size_t along) {
    const int count = cells.cells()[along];
    for (; to[along] < 0; to[along] += count) --periods[along];
    for (; to[along] >= count; to[along] -= count) ++periods[along];
  };
  // Without slides all layers have one frame.
  const int layers = search_.has_slides() && axis == 1 ? direction : 0;
  to[a] += direction;
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
  const auto fresh = search_.beyond(cells, {axis, direction, from, to});
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
