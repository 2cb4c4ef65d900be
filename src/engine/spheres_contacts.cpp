// When a sphere touches its neighbours: one after the other.

#include "engine/spheres.hpp"
#include "model/falling_contact.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim, class Real>
void Spheres<Dim, Real>::find_contacts_of_unit_spheres(std::int32_t i,
                                                       std::span<const Neighbour> neighbours,
                                                       const Real& when,
                                                       ContactsAhead<Real>& ahead) const {
  const Viewpoint<Dim, Real> here = viewpoint(i, when);
  const FloatingPointFilter<Dim> roughly(here);
  for (const Neighbour neighbour : neighbours) {
    if constexpr (!std::is_floating_point_v<Real>) {  // dear numbers
      const Image<Dim, Real>& image = sliding_box_.image(neighbour.periodic_image());
      if (!fall_ && roughly.misses((*this)[neighbour.sphere()], image)) continue;
    }
    const auto contact = zenosphere::contact(motion_from(here, neighbour));
    if (contact) ahead.add(neighbour.sphere(), *contact);
  }
}

/// As find_contacts_of_unit_spheres(), with the mean diameter of each pair; and of two of which one
/// falls.
template <int Dim, class Real>
void Spheres<Dim, Real>::find_contacts_in_mixture(std::int32_t i,
                                                  std::span<const Neighbour> neighbours,
                                                  const Real& when,
                                                  ContactsAhead<Real>& ahead) const {
  const Viewpoint<Dim, Real> here = viewpoint(i, when);
  const FloatingPointFilter<Dim> roughly(here);
  for (const Neighbour neighbour : neighbours) {
    const std::int32_t j = neighbour.sphere();
    const Real sigma = this->sigma(i, j);
    if constexpr (!std::is_floating_point_v<Real>) {  // dear numbers
      const Image<Dim, Real>& image = sliding_box_.image(neighbour.periodic_image());
      if (!fall_ && roughly.misses((*this)[j], image, static_cast<double>(sigma))) continue;
    }
    const auto motion = motion_from(here, neighbour);
    const auto contact = fall_apart(i, j) ? falling_contact(motion, pull(j) - pull(i), sigma)
                                          : zenosphere::contact(motion, sigma);
    if (contact) ahead.add(j, *contact);
  }
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                                 \
  template void Spheres<Dim, Real>::find_contacts_of_unit_spheres(                        \
      std::int32_t, std::span<const Neighbour>, const Real&, ContactsAhead<Real>&) const; \
  template void Spheres<Dim, Real>::find_contacts_in_mixture(                             \
      std::int32_t, std::span<const Neighbour>, const Real&, ContactsAhead<Real>&) const;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
