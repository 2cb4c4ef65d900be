#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/shear_box.hpp"
#include "model/vec.hpp"

namespace zenosphere {

/// Two spheres that are close: seen from i, the centre of j is at positions[j] + shift.
template <int Dim>
struct ClosePair {
  std::int32_t i;
  std::int32_t j;
  Vec<Dim, double> shift;  ///< whole sides of the box along the periodic axes
};

/// All pairs of spheres whose surfaces are closer than a margin, each once for every image in which
/// they are; a sphere and its own images are no pair.
///
/// Spheres are sorted by the octave of their diameter into grids of their own, so that small
/// spheres among large ones look at few others.
///
/// \param positions  N, in [0, side) along each axis
/// \param diameters  N, > 0, none above a side
/// \param box        at strain 0
/// \param margin     > 0, at most half the shortest periodic side
/// The order of the pairs depends on the arguments alone.
/// Source: one grid a size, Ogarko & Luding, Comput. Phys. Commun. 183 (2012) 931.
template <int Dim>
std::vector<ClosePair<Dim>> close_pairs(std::span<const Vec<Dim, double>> positions,
                                        std::span<const double> diameters,
                                        const ShearBox<Dim, double>& box, double margin);

}  // namespace zenosphere
