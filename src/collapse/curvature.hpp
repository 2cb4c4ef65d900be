#pragma once

#include <optional>
#include <span>

namespace zenosphere {

/// What the curvature of the contacts does to gaps that fall together in two or three dimensions.
///
/// Spheres that pass each other at a tangential speed v_t are accelerated apart by v_t^2 over a
/// diameter. In a flight of duration D that takes v_t^2 D of the closing speed w. The *margin* of a
/// contact is how many decades v_t^2 D / w lies below one. Where durations fall faster than closing
/// speeds it grows, and the fall becomes ever more like that of rods. Where they fall more slowly
/// it shrinks, and one day the curvature opens the gaps again.
///
/// Source: docs/decisions/0019-certificates.md, q < g.
struct Curvature {
  double margin = 0;      ///< decades at the end, of the one contact in a hundred where least
  double per_decade = 0;  ///< its change for each decade of the gap
  double depth = 0;       ///< decades of the gap at the end
};

/// The decade of the gap at which the margin will be used up, if it shrinks.
std::optional<double> gives_way_at(const Curvature& curvature);

/// The curvature in a fall, by a straight line through up to sixteen parts of it; nothing for fewer
/// than 16 contacts, or where so few spheres slide that nothing bends, as in a straight row.
///
/// \param depths   median decades of the gap at each contact, in order, rising
/// \param margins  of each contact, decades; infinite where nothing slides
std::optional<Curvature> curvature_of(std::span<const double> depths,
                                      std::span<const double> margins);

}  // namespace zenosphere
