#include "engine/spheres.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <stdexcept>

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
  displace_images(start.offset);
  place(start);
  start = {};  // whose memory the lists can use
  if (search_) return;
  for (std::int32_t i = 0; i < count(); ++i) {
    // As if it had been alone until now.
    remove_reference(i);
    const std::span<Neighbour> neighbours = neighbours_of(i, 0);
    lists_.replace(i, neighbours, lists_.changes(i, neighbours));
    insert_reference(i);
    is_crowded_ = is_crowded_ || (list_range_.is_wide && neighbours.size() > most_alone);
  }
  if (is_crowded_) rebuild_in_crowd(0);
}

/// Spheres that are in no cell and on no list yet.
template <int Dim, class Real>
Spheres<Dim, Real>::Spheres(HugePageVector<Sphere> spheres, Grains<Real> grains,
                            const ShearBox<Dim, Real>& box, const Vector& acceleration)
    : box_(box),
      cells_(box.cells()),
      acceleration_(acceleration),
      falls_(!(acceleration == Vector{})),
      some_are_held_(falls_ && !grains.immobile.empty()),
      lanes_are_wide_(!falls_ && has_wide_lanes()),
      grains_(std::move(grains)),
      largest_(grains_.largest_diameter()),
      is_mixture_(!grains_.diameters.empty() || !grains_.immobile.empty()),
      list_range_(list_range_in(box, static_cast<std::int32_t>(spheres.size()), sizes_of(grains_))),
      spheres_(std::move(spheres)),
      boxes_(spheres_.size()),
      lists_(0, 0),
      reference_cells_(0) {
  for (int axis = 0; axis < Dim; ++axis) {
    cell_grains_[static_cast<std::size_t>(axis)] =
        static_cast<int>(static_cast<double>(box_.cell_width()[axis]) / list_range_.grain + 0.5);
  }
  if (box.is_sheared()) slide_grains_ = cell_grains_[0] / (2 * list_range_.lists_a_cell) + 1;
  for (const Real& diameter : grains_.diameters) radii_.push_back(diameter / 2);
  require_room();
  find_images();
  if (!falls_ && cells_suffice(box, count(), sizes_of(grains_))) {
    use_cells();
  } else {
    use_lists();
  }
}

/// Throws std::invalid_argument where a sphere could touch another one beyond the next cell.
template <int Dim, class Real>
void Spheres<Dim, Real>::require_room() const {
  if (are_of_one_size()) return;
  for (int axis = 0; axis < Dim; ++axis) {
    const bool is_alone = box_.is_closed(axis) && box_.cells()[static_cast<std::size_t>(axis)] == 2;
    const Real least = (is_alone ? Real(1) : Real(narrowest_cell)) * largest_;
    if (!(box_.cell_width()[axis] >= least)) throw std::invalid_argument("box too narrow");
  }
}

/// Where the images of the box along y are at the start.
///
/// \param offset  0 in one dimension, and where the box is closed along x or y
template <int Dim, class Real>
void Spheres<Dim, Real>::displace_images(const Real& offset) {
  using std::floor;
  if (offset == 0) return;
  assert(Dim > 1 && !box_.is_closed(0) && !box_.is_closed(1));
  offset_ = offset;
  const Real columns = offset / box_.cell_width()[0];
  const Real whole = floor(columns);
  cells_.displace_images(static_cast<int>(whole));
  odd_offset_ = static_cast<double>(Real(columns - whole));
  if (search_) search_->displace_images();
  find_images();
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
    sphere.velocity = start.velocities[static_cast<std::size_t>(i)];
    sphere.velocity[0] += profile_in_layer(sphere, 0);
  }
  // Before there are lists: those of all that are in such a cell would be too long.
  if (list_range_.is_wide && is_crowd_in_a_cell()) {
    list_range_ = list_range_in_crowd(box_, count(), sizes_of(grains_));
  }
  for (std::int32_t i = 0; i < count(); ++i) {
    if (search_) {
      search_->insert(i, cells_.coordinates((*this)[i].cell));
    } else {
      put_reference(i, 0, {});
      insert_reference(i);
    }
  }
}

/// How the coordinates of a neighbour are seen in each periodic image, at remainder 0.
template <int Dim, class Real>
void Spheres<Dim, Real>::find_images() {
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
Neighbour Spheres<Dim, Real>::neighbour(std::int32_t i, std::int32_t j, const Real& when) const {
  if (search_) {
    const auto periodic_image = search_->periodic_image(cells_, cells_.coordinates((*this)[i].cell),
                                                        cells_.coordinates((*this)[j].cell));
    return periodic_image ? Neighbour(j, *periodic_image) : nearest_image(i, j, when);
  }
  const auto neighbours = lists_.of(i);
  std::uint64_t places = lists_.places(i, j);
  if (places == 0) return not_listed_first(i, j, when);
  Neighbour nearest = neighbours[static_cast<std::size_t>(std::countr_zero(places))];
  places &= places - 1;
  if (places == 0) [[likely]]
    return nearest;
  for (; places != 0; places &= places - 1) {
    const Neighbour other = neighbours[static_cast<std::size_t>(std::countr_zero(places))];
    if (square(i, other, when) < square(i, nearest, when)) nearest = other;
  }
  return nearest;
}

/// As neighbour(), where j is not among the first on the list of i: a large sphere may have many
/// small neighbours, of whose shorter lists it is on the first places.
template <int Dim, class Real>
Neighbour Spheres<Dim, Real>::not_listed_first(std::int32_t i, std::int32_t j,
                                               const Real& when) const {
  const auto neighbours = lists_.of(j);
  const std::uint64_t places = lists_.places(j, i);
  const bool is_all = neighbours.size() <= NeighbourLists::most_places;
  if (!is_all || !std::has_single_bit(places)) return nearest_image(i, j, when);
  return neighbours[static_cast<std::size_t>(std::countr_zero(places))].reversed(j);
}

/// As neighbour(), whether or not it is on a list: of all images that lead from one layer to the
/// other.
template <int Dim, class Real>
Neighbour Spheres<Dim, Real>::nearest_image(std::int32_t i, std::int32_t j,
                                            const Real& when) const {
  const Steps<Dim> from = cells_.coordinates((*this)[i].cell);
  const Steps<Dim> to = cells_.coordinates((*this)[j].cell);
  Neighbour nearest(j, PeriodicImage());
  Real least = std::numeric_limits<Real>::infinity();
  for (std::int32_t code = 0; code < PeriodicImage::count; ++code) {
    const PeriodicImage periodic_image = PeriodicImage::from_code(code);
    if constexpr (Dim > 1) {
      if (to[1] + periodic_image.periods(1) * box_.cells()[1] - from[1] != periodic_image.layers())
        continue;
    }
    const Real distance = square(i, Neighbour(j, periodic_image), when);
    if (!(distance < least)) continue;
    least = distance;
    nearest = Neighbour(j, periodic_image);
  }
  return nearest;
}

template <int Dim, class Real>
Vec<Dim, Real> Spheres<Dim, Real>::shortest_image(Vector displacement, const Real& when) const {
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
Real Spheres<Dim, Real>::square(std::int32_t i, Neighbour neighbour, const Real& when) const {
  const Vector dr = motion(i, neighbour, when).dr;
  return dot(dr, dr);
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
