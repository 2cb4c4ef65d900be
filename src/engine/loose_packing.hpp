#pragma once

#include <cstdint>
#include <vector>

#include "model/random.hpp"
#include "model/vec.hpp"

namespace zenosphere {

/// Random places of unit spheres without overlaps in a periodic cube.
///
/// Uniform points, then sweeps in which every overlapping pair is pushed apart by half of its
/// overlap each, until none is left. The places are not those of an equilibrium fluid; a few
/// elastic collisions per sphere make them so.
///
/// \param side  of the cube, > 2 diameters
/// Throws std::invalid_argument if overlaps remain: in three dimensions that happens above a
/// solids volume fraction of about 0.6.
/// Source: the overlap-removal step of Jodrey & Tory, Phys. Rev. A 32 (1985) 2347.
template <int Dim>
std::vector<Vec<Dim, double>> loose_packing(std::int32_t spheres, double side, Random& random);

}  // namespace zenosphere
