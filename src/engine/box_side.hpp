#pragma once

#include <cstdint>

namespace zenosphere {

/// Side of the cube in which `spheres` unit spheres fill a fraction of the volume, diameters; in
/// two dimensions discs and a square, in one rods and a line.
///
/// Made of IEEE operations only, so that it is the same on every machine.
template <int Dim>
double box_side(std::int64_t spheres, double solids_volume_fraction);

}  // namespace zenosphere
