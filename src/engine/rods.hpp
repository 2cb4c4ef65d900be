#pragma once

#include <span>
#include <vector>

#include "model/random.hpp"
#include "model/shear_box.hpp"
#include "model/vec.hpp"

namespace zenosphere {

/// Equilibrium places of rods, which stand in the order of their lengths [N, units of length], on a
/// ring or, between walls, on a line: the gaps are those between random points.
///
/// Throws std::invalid_argument where they leave no room.
/// Source: Tonks, Phys. Rev. 50 (1936) 955.
std::vector<Vec<1, double>> rod_places(std::span<const double> lengths,
                                       const ShearBox<1, double>& box, Random& random);

}  // namespace zenosphere
