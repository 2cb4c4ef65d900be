#pragma once

#include <optional>
#include <span>

#include "engine/contacts_ahead.hpp"
#include "engine/neighbour_lists.hpp"
#include "engine/sphere.hpp"
#include "model/shear_box.hpp"

namespace zenosphere {

/// The first two contacts with neighbours, found four at a time, each with the very operations that
/// contact() does for one. Only where has_wide_lanes().
///
/// \param neighbours  three more, of any spheres, have to follow the last
/// \param images      of each PeriodicImage, at remainder 0
/// \return nothing where it takes a look at each one: of overlaps, equal times, long lists
template <int Dim>
std::optional<FirstContacts<double>> first_contacts_wide(const Sphere<Dim, double>* spheres,
                                                         std::span<const Neighbour> neighbours,
                                                         const Image<Dim, double>* images,
                                                         const Viewpoint<Dim, double>& viewpoint);

/// The same of spheres that differ in size.
///
/// \param radii  of all spheres
/// \param own    number of the sphere that looks
template <int Dim>
std::optional<FirstContacts<double>> first_contacts_wide(const Sphere<Dim, double>* spheres,
                                                         std::span<const Neighbour> neighbours,
                                                         const Image<Dim, double>* images,
                                                         const Viewpoint<Dim, double>& viewpoint,
                                                         const double* radii, std::int32_t own);

}  // namespace zenosphere
