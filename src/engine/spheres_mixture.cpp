// Spheres that differ in size, or of which some never move.

#include <algorithm>
#include <cmath>

#include "engine/spheres.hpp"
#include "model/falling_contact.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

/// As find_contacts(), with the mean diameter of each pair.
template <int Dim, class Real>
void Spheres<Dim, Real>::find_contacts_of(std::int32_t i, std::span<const Neighbour> neighbours,
                                          const Real& when, ContactsAhead<Real>& ahead) const {
  const Viewpoint<Dim, Real> here = viewpoint(i, when);
  const FloatingPointFilter<Dim> roughly(here);
  for (const Neighbour neighbour : neighbours) {
    const std::int32_t j = neighbour.sphere();
    const Real sigma = this->sigma(i, j);
    if constexpr (!std::is_floating_point_v<Real>) {  // dear numbers
      const auto rough_sigma = static_cast<double>(sigma);
      if (!falls_ && roughly.misses((*this)[j], image(neighbour.periodic_image()), rough_sigma))
        continue;
    }
    const auto motion = motion_from(here, neighbour);
    const auto contact = fall_apart(i, j)
                             ? falling_contact(motion, pull((*this)[j]) - pull((*this)[i]), sigma)
                             : zenosphere::contact(motion, sigma);
    if (contact) ahead.add(j, *contact);
  }
}

template <int Dim, class Real>
void Spheres<Dim, Real>::insert_reference(std::int32_t i) {
  const std::int32_t cell = (*this)[i].cell;
  if (!sized_cells_) [[likely]]
    return reference_cells_.insert(i, cell, reference(i));
  sized_cells_->insert(i, cell, reference(i));
}

template <int Dim, class Real>
void Spheres<Dim, Real>::remove_reference(std::int32_t i) {
  const std::int32_t cell = (*this)[i].cell;
  if (!sized_cells_) [[likely]]
    return reference_cells_.remove(i, cell);
  sized_cells_->remove(i, cell, reference(i));
}

/// As neighbours_of_one_size(), each pair by its own distance.
template <int Dim, class Real>
std::span<Neighbour> Spheres<Dim, Real>::neighbours_by_size(std::int32_t i, const Real& when) {
  const Steps<Dim> home = cells_.coordinates((*this)[i].cell);
  return sized_cells_->find(cells_, viewer(i, home, reference(i).place, when), nearby_);
}

/// \param home   the cell in which it is, or will be
/// \param place  there, grains
template <int Dim, class Real>
typename SizedReferenceCells<Dim>::Viewer Spheres<Dim, Real>::viewer(
    std::int32_t i, const Steps<Dim>& home, const ReferencePosition::Place& place,
    const Real& when) const {
  const double beyond = list_range_.distance - static_cast<double>(largest_);
  const SlidGrains slid = slid_grains(slides(home, when));
  return {.sphere = i,
          .home = home,
          .place = place,
          .slid = slid.layers,
          .slide = slid.either_way,
          .beyond = static_cast<int>(std::ceil(beyond / list_range_.grain))};
}

/// Without those that are immobile: two that never change their velocity do not meet, they are
/// where the start has put them.
template <int Dim, class Real>
std::span<Neighbour> Spheres<Dim, Real>::without_immobile(std::span<Neighbour> neighbours) const {
  const auto is_immobile = [&](Neighbour neighbour) {
    return grains_.is_immobile(neighbour.sphere());
  };
  const auto end = std::remove_if(neighbours.begin(), neighbours.end(), is_immobile);
  return neighbours.first(static_cast<std::size_t>(end - neighbours.begin()));
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                                          \
  template void Spheres<Dim, Real>::find_contacts_of(std::int32_t, std::span<const Neighbour>,     \
                                                     const Real&, ContactsAhead<Real>&) const;     \
  template void Spheres<Dim, Real>::insert_reference(std::int32_t);                                \
  template void Spheres<Dim, Real>::remove_reference(std::int32_t);                                \
  template std::span<Neighbour> Spheres<Dim, Real>::neighbours_by_size(std::int32_t, const Real&); \
  template typename SizedReferenceCells<Dim>::Viewer Spheres<Dim, Real>::viewer(                   \
      std::int32_t, const Steps<Dim>&, const ReferencePosition::Place&, const Real&) const;        \
  template std::span<Neighbour> Spheres<Dim, Real>::without_immobile(std::span<Neighbour>) const;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
