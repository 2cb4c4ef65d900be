#pragma once

#include <vector>

#include "case/case.hpp"
#include "model/grains.hpp"

namespace zenosphere {

/// Distance by which spheres may overlap each other or a wall at the start, diameters: what
/// rounding leaves of a contact.
inline constexpr double touching = 1e-12;

/// Positions and velocities that a case gives instead of having them made.
struct GivenStart {
  int dimension = 0;               ///< D
  std::vector<double> positions;   ///< N x D, row-major, diameters; in the box, [0, L)
  std::vector<double> velocities;  ///< N x D, row-major, laboratory, diameters/time; empty where
                                   ///< they are to be drawn at start.granular_temperature
  std::vector<double> sides;       ///< D, diameters: those of the box
  double offset = 0;               ///< of the upper image of the box along x, in [-L/2, L/2),
                                   ///< diameters
  Grains<double> grains{};         ///< what the spheres are
  std::vector<double> spins{};  ///< N x 3, in two dimensions N, radians/time; empty: nothing turns
};

/// The start that a case writes (Arrangement::given) or names (Arrangement::file), checked: right
/// numbers of finite numbers, every sphere clear of the walls, no two overlapping by more than
/// 1e-12 diameters, something that moves, and no sphere that rests on a wall under gravity. What is
/// outside the box along a periodic axis is wrapped into it; across y of a sheared box the image
/// has the velocity of the profile there.
///
/// A file is an output file of this program or else extended XYZ; start.snapshot, or the last of
/// its snapshots or frames, counts. The box that it tells must be that of the case, but for the
/// Lees-Edwards offset that it had come to: the images stay where they were. Diameters and masses
/// that it tells must be those of the case, to 1e-9; with_species_of_start takes them over.
///
/// \param values  a checked case, as read_case gives it, with one of the two arrangements
/// Throws InputError, which names spheres by their number from 0.
GivenStart given_start(const Case& values);

}  // namespace zenosphere
