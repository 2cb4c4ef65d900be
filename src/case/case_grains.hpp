#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "case/case.hpp"
#include "model/contact_table.hpp"
#include "model/grains.hpp"

namespace zenosphere {

/// Largest spread of a distribution whose diameters are all positive, and lie in no longer tail
/// than it describes: 1/sqrt(3) for the uniform one, a third of its cut for the normal one, 1 for
/// the lognormal one.
double largest_spread(SizeDistribution distribution);

/// The constants of contact of each pair of kinds, if they are not system.restitution for all.
template <class Real>
std::optional<ContactTable<Real>> contact_table_of(const Case& values);

/// Whether spheres turn: some pair sticks or slides.
bool is_rough(const Case& values);

/// q = 4 I / (m s^2) of rough spheres: that of the case, or of solid spheres and disks.
double reduced_moment_of_inertia(const Case& values);

/// Whether all are smooth unit spheres of one kind that collide at one restitution law.
bool are_unit_spheres(const Case& values);

/// Whether there are obstacles among the spheres.
bool has_immobile_species(const Case& values);

/// Number of spheres of each species, in their order; they add up to system.spheres. Shares are
/// rounded down, and those that lose most get one of the spheres left over.
///
/// \param values  with at least one species
std::vector<std::int64_t> spheres_by_species(const Case& values);

/// What the spheres of a case are: those of the first species first, with diameters drawn from
/// start.seed where they are polydisperse. All empty for unit spheres of one kind.
///
/// The same bits on every machine. A normal distribution is cut off at three of its standard
/// deviations on both sides, which is made up for: `spread` is that of what is left.
Grains<double> grains_of(const Case& values);

/// What follows from the diameters of all spheres.
SizeSummary sizes_of(const Case& values);

}  // namespace zenosphere
