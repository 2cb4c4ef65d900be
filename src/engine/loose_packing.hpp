#pragma once

#include <cstdint>
#include <vector>

#include "model/random.hpp"
#include "model/shear_box.hpp"
#include "model/vec.hpp"

namespace zenosphere {

/// Random places of unit spheres without overlaps in a box at strain 0.
///
/// Uniform points, then sweeps in which every overlapping pair is pushed apart by half of its
/// overlap each, until none is left. The places are not those of an equilibrium fluid; a few
/// elastic collisions per sphere make them so. On a line the places are drawn from equilibrium at
/// once: the gaps between rods are those between random points.
///
/// Throws std::invalid_argument if overlaps remain: in three dimensions that happens above a
/// solids volume fraction of about 0.6.
/// Source: the overlap-removal step of Jodrey & Tory, Phys. Rev. A 32 (1985) 2347; on the line
/// Tonks, Phys. Rev. 50 (1936) 955.
template <int Dim>
std::vector<Vec<Dim, double>> loose_packing(std::int32_t spheres, const ShearBox<Dim, double>& box,
                                            Random& random);

}  // namespace zenosphere
