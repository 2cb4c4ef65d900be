// Spheres that differ in size, or of which some never move.

#include <algorithm>
#include <cmath>

#include "engine/spheres.hpp"
#include "model/falling_contact.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

/// The least size of a number that changes from `from` to `to`.
double least_size(double from, double to) {
  if ((from < 0) != (to < 0)) return 0;
  return std::min(std::abs(from), std::abs(to));
}

}  // namespace

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
      if (!falls_ && roughly.misses((*this)[j], image(neighbour.way()), rough_sigma)) continue;
    }
    const auto motion = motion_from(here, neighbour);
    const auto contact = fall_apart(i, j)
                             ? falling_contact(motion, pull((*this)[j]) - pull((*this)[i]), sigma)
                             : zenosphere::contact(motion, sigma);
    if (contact) ahead.add(j, *contact);
  }
}

/// Those of i's neighbours that it can touch: the search has taken all for the largest.
///
/// Two that never change their velocity do not meet: they are where the start has put them.
template <int Dim, class Real>
std::span<Neighbour> Spheres<Dim, Real>::keep_within_reach(std::int32_t i,
                                                           std::span<Neighbour> neighbours,
                                                           const Real& when) const {
  const auto anchor_of = [&](std::int32_t k) {
    const Vector corner = this->corner((*this)[k].cell);
    Vec<Dim, double> place;
    for (int axis = 0; axis < Dim; ++axis) {
      const int grains = anchor(k).place[static_cast<std::size_t>(axis)];
      place[axis] = static_cast<double>(corner[axis]) + grains * settling_.grain;
    }
    return place;
  };
  const Vec<Dim, double> here = anchor_of(i);
  const double most = settling_.distance - static_cast<double>(largest_);
  const auto is_out_of_reach = [&](Neighbour neighbour) {
    const std::int32_t j = neighbour.sphere();
    if (grains_.is_immobile(i) && grains_.is_immobile(j)) return true;
    if (are_of_one_size()) return false;
    const Image<Dim, Real>& image = this->image(neighbour.way());
    Vec<Dim, double> between = anchor_of(j) - here;
    for (int axis = 0; axis < Dim; ++axis) {
      between[axis] += static_cast<double>(image.position[axis]);
    }
    // Layers slide while the list lasts.
    const auto slide = static_cast<double>(image.velocity);
    if (slide != 0) {
      between[0] += slide * static_cast<double>(when);
      between[0] = least_size(between[0], between[0] + slide * settling_.window);
    }
    const double reach = most + static_cast<double>(sigma(i, j));
    return dot(between, between) > reach * reach;
  };
  const auto end = std::remove_if(neighbours.begin(), neighbours.end(), is_out_of_reach);
  return neighbours.first(static_cast<std::size_t>(end - neighbours.begin()));
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                                      \
  template void Spheres<Dim, Real>::find_contacts_of(std::int32_t, std::span<const Neighbour>, \
                                                     const Real&, ContactsAhead<Real>&) const; \
  template std::span<Neighbour> Spheres<Dim, Real>::keep_within_reach(                         \
      std::int32_t, std::span<Neighbour>, const Real&) const;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
