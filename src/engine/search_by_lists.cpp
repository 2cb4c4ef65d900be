#include "engine/search_by_lists.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/floor_within.hpp"
#include "model/instantiate.hpp"
#include "model/walls.hpp"

namespace zenosphere {

template <int Dim, class Real>
Neighbour SearchByLists<Dim, Real>::neighbour(const Spheres<Dim, Real>& spheres, std::int32_t i,
                                              std::int32_t j, const Real& when) const {
  const auto neighbours = lists_.of(i);
  std::uint64_t places = lists_.places(i, j);
  if (places == 0) return not_listed_first(spheres, i, j, when);
  Neighbour nearest = neighbours[static_cast<std::size_t>(std::countr_zero(places))];
  places &= places - 1;
  if (places == 0) [[likely]]
    return nearest;
  for (; places != 0; places &= places - 1) {
    const Neighbour other = neighbours[static_cast<std::size_t>(std::countr_zero(places))];
    if (spheres.square_of_distance(i, other, when) < spheres.square_of_distance(i, nearest, when))
      nearest = other;
  }
  return nearest;
}

/// As neighbour(), where j is not among the first on the list of i: a large sphere may have many
/// small neighbours, of whose shorter lists it is on the first places.
template <int Dim, class Real>
Neighbour SearchByLists<Dim, Real>::not_listed_first(const Spheres<Dim, Real>& spheres,
                                                     std::int32_t i, std::int32_t j,
                                                     const Real& when) const {
  const auto neighbours = lists_.of(j);
  const std::uint64_t places = lists_.places(j, i);
  const bool is_all = neighbours.size() <= NeighbourLists::most_places;
  if (!is_all || !std::has_single_bit(places)) return spheres.nearest_image(i, j, when);
  return neighbours[static_cast<std::size_t>(std::countr_zero(places))].reversed(j);
}

template <int Dim, class Real>
Real SearchByLists<Dim, Real>::plan_renewal(const Spheres<Dim, Real>& spheres, std::int32_t i,
                                            const Real& when, const Real& until) const {
  const Vector velocity = spheres.velocity_at(i, when);
  const Vector away = from_middle(spheres, i, spheres.position_at(i, when));
  const Real expires = static_cast<Real>(double{reference(i).expires} * range_.expiry_unit);
  const bool is_straight = spheres.fly_straight();
  if (is_straight) {
    // Most spheres meet another one before they leave their ball: that needs no root.
    const Vector then = away + velocity * (until - when);
    const Real reach = Real(range_.reach);
    if (dot(then, then) < reach * reach) return expires;
  }
  const Real left = when + (is_straight ? time_in_ball(away, velocity)
                                        : time_in_cube(away, velocity, spheres.pull(i)));
  return left < expires ? left : expires;
}

/// Time until a sphere that flies straight is so far from its reference position as its ball
/// reaches.
///
/// \param away  its place relative to the reference position
template <int Dim, class Real>
Real SearchByLists<Dim, Real>::time_in_ball(const Vector& away, const Vector& velocity) const {
  using std::sqrt;
  const Real v2 = dot(velocity, velocity);
  if (!(v2 > 0)) return std::numeric_limits<Real>::infinity();
  const Real b = dot(away, velocity);
  const Real room = Real(range_.reach) * Real(range_.reach) - dot(away, away);
  if (!(room > 0)) return 0;  // outside already, by rounding
  const Real root = sqrt(b * b + v2 * room);
  if (!(root > 0)) return std::numeric_limits<Real>::infinity();  // too slow for the exponent
  return b > 0 ? room / (b + root) : (root - b) / v2;
}

/// Time until a falling sphere leaves the cube inside that ball.
template <int Dim, class Real>
Real SearchByLists<Dim, Real>::time_in_cube(const Vector& away, const Vector& velocity,
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

/// Half the side of the cube inside the ball that is within reach, diameters.
template <int Dim, class Real>
double SearchByLists<Dim, Real>::reach_along_axes() const {
  return range_.reach / std::sqrt(double{Dim});
}

template <int Dim, class Real>
std::span<const Neighbour> SearchByLists<Dim, Real>::renew(Spheres<Dim, Real>& spheres,
                                                           std::int32_t i, const Real& when,
                                                           const Real& meeting) {
  remove_reference(spheres, i);
  const Vector ahead =
      displacement_of_reference(spheres, spheres.velocity_at(i, when), meeting - when);
  // Every image may lie elsewhere now. In a narrow box, with several images of one neighbour, one
  // that is known could pass for another one that is new.
  const bool is_seen_anew = spheres.go_home(i, when, ahead) != PeriodicImage();
  const NeighbourLists::Changes all_gone{};
  const bool is_worth_prefetching = spheres.count() > most_spheres_in_cache;
  if (is_seen_anew && is_worth_prefetching) lists_.prefetch(i, {}, all_gone);
  put_reference(spheres, i, when, ahead);
  const std::span<Neighbour> neighbours = find_neighbours(spheres, i, when);
  if (is_seen_anew) lists_.replace(i, {}, all_gone);
  const NeighbourLists::Changes changes = lists_.changes(i, neighbours);
  const std::span<const Neighbour> fresh = neighbours.first(changes.fresh);
  if (is_worth_prefetching) {
    for (const Neighbour neighbour : fresh) spheres.prefetch(neighbour.sphere());
    lists_.prefetch(i, neighbours, changes);
  }
  lists_.replace(i, neighbours, changes);
  insert_reference(spheres, i);
  note_crowd(neighbours);
  // What looks at four at once looks beyond the end: at none for which it would have to wait.
  if (!fresh.empty()) std::fill_n(neighbours.data() + changes.fresh, 3, fresh.back());
  return fresh;
}

/// How far ahead of a sphere its reference position lies. In a dilute system that is where it is
/// going to meet another one, unless it leaves its ball before: it flies straight until then, and
/// stays in the ball up to twice as long as if that were around the place where its list is
/// renewed.
///
/// \param flight  time until the meeting; infinity: there is none
template <int Dim, class Real>
Vec<Dim, Real> SearchByLists<Dim, Real>::displacement_of_reference(
    const Spheres<Dim, Real>& spheres, const Vector& velocity, const Real& flight) const {
  using std::sqrt;
  if (!range_.is_dilute) return {};
  constexpr double share = 0.9;  // of the way to the edge, which rounding must not take it over
  const Real v2 = dot(velocity, velocity);
  if (!(v2 > 0)) return {};
  const double farthest = share * (spheres.fly_straight() ? range_.reach : reach_along_axes());
  const Real longest = Real(farthest) / sqrt(v2);
  return velocity * std::clamp(flight, Real(0), longest);
}

/// \param ahead  from where the sphere is at `when` to its reference position
template <int Dim, class Real>
void SearchByLists<Dim, Real>::put_reference(const Spheres<Dim, Real>& spheres, std::int32_t i,
                                             const Real& when, const Vector& ahead) {
  ReferencePosition& reference = this->reference(i);
  reference.place = place_in_cell(spheres, spheres[i].cell, spheres.position_at(i, when) + ahead);
  reference.expires =
      static_cast<float>((static_cast<double>(when) + range_.window) / range_.expiry_unit);
}

/// A place from the lower corner of a cell, in grains.
template <int Dim, class Real>
ReferencePosition::Place SearchByLists<Dim, Real>::place_in_cell(const Spheres<Dim, Real>& spheres,
                                                                 std::int32_t cell,
                                                                 const Vector& place) const {
  const Vector corner = spheres.sliding_box().corner(cell);
  ReferencePosition::Place in_cell{};
  for (int axis = 0; axis < Dim; ++axis) {
    const double grains = static_cast<double>(place[axis] - corner[axis]) / range_.grain;
    in_cell[static_cast<std::size_t>(axis)] =
        static_cast<std::int16_t>(floor_within(0, ReferenceCells::grains_a_cell, grains + 0.5));
  }
  return in_cell;
}

/// All that i can touch, which is not among the reference positions now. Two that are immobile
/// never change their velocity and do not meet: they are where the start has put them.
template <int Dim, class Real>
std::span<Neighbour> SearchByLists<Dim, Real>::find_neighbours(const Spheres<Dim, Real>& spheres,
                                                               std::int32_t i, const Real& when) {
  const Steps<Dim> home = spheres.home(i);
  const std::span<Neighbour> near = references_.find(
      spheres.cells(), {i, home, reference(i).place, spheres.sliding_box().slides(home, when)});
  if (!spheres.grains().is_immobile(i)) [[likely]]
    return near;
  const auto end = std::remove_if(near.begin(), near.end(), [&](Neighbour neighbour) {
    return spheres.grains().is_immobile(neighbour.sphere());
  });
  return near.first(static_cast<std::size_t>(end - near.begin()));
}

template <int Dim, class Real>
void SearchByLists<Dim, Real>::prefetch_around(const Spheres<Dim, Real>& spheres, std::int32_t i,
                                               const Real& when) const {
  const SlidingBox<Dim, Real>& box = spheres.sliding_box();
  Vector place = spheres.position_at(i, when);
  const auto [cell, periodic_image] = box.home(place, spheres[i].cell, when);
  if (periodic_image != PeriodicImage()) {
    const Image<Dim, Real>& image = box.image(periodic_image);
    place -= image.position;
    place[0] -= image.velocity * when;
  }
  const Steps<Dim> home = spheres.cells().coordinates(cell);
  references_.prefetch(spheres.cells(),
                       {i, home, place_in_cell(spheres, cell, place), box.slides(home, when)});
}

template <int Dim, class Real>
void SearchByLists<Dim, Real>::shift_times(const Spheres<Dim, Real>& spheres, const Real& span) {
  if (!spheres.box().is_sheared()) return;
  const auto units = static_cast<float>(static_cast<double>(span) / range_.expiry_unit);
  for (std::int32_t i = 0; i < spheres.count(); ++i) reference(i).expires -= units;
  if (spheres.cells().whole_slide() == 0) lists_.turn();
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class SearchByLists<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
