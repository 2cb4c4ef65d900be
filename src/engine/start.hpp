#pragma once

#include <cstdint>

#include "engine/arrangement.hpp"
#include "engine/simulation.hpp"

namespace zenosphere {

/// What a start is made from.
struct StartRequest {
  Arrangement arrangement = Arrangement::fcc;
  std::int32_t spheres = 0;
  double granular_temperature = 0;  ///< (diameter/time)^2
  std::uint64_t seed = 1;
};

/// Side of the cubic box in which `spheres` unit spheres fill a fraction of the volume, diameters.
///
/// Made of IEEE operations only, so that it is the same on every machine.
template <int Dim>
double box_side(std::int64_t spheres, double solids_volume_fraction);

/// Spheres placed in a cubic box, with Gaussian peculiar velocities.
///
/// The velocities have exactly zero mean and exactly the wanted granular temperature, up to
/// rounding. The same request gives the same bits on every machine. Starts are made in `double`,
/// so that runs of every precision can begin from the same state.
///
/// \param side  of the box, diameters
/// Throws std::invalid_argument where the arrangement cannot be made: fcc with a number of spheres
/// that is not 4 n^3, or random places too dense to be free of overlaps.
template <int Dim>
Configuration<Dim, double> make_start(const StartRequest& request, double side);

}  // namespace zenosphere
