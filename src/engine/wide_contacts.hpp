#pragma once

#include <span>

#include "engine/contacts_ahead.hpp"
#include "engine/neighbour_lists.hpp"
#include "engine/sphere.hpp"
#include "model/shear_box.hpp"

namespace zenosphere {

/// Adds the contacts with neighbours, four at a time, each with the very operations that contact()
/// does for one. Only where has_wide_lanes().
///
/// \param neighbours  three more, of any spheres, have to follow the last
/// \param images      of each Way, at remainder 0
void find_contacts_wide(const Sphere<3, double>* spheres, std::span<const Neighbour> neighbours,
                        const Image<3, double>* images, const Viewpoint<3, double>& viewpoint,
                        ContactsAhead<double>& ahead);

/// What first_two() finds, four at a time. Only where has_wide_lanes().
FirstTwo first_two_wide(ContactsAhead<double>& ahead, double now);

}  // namespace zenosphere
