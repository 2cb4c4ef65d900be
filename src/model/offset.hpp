#pragma once

#include <cmath>

namespace zenosphere {

/// The offset of the images of a sheared box along its flow that gives the same lattice and lies in
/// [-side/2, side/2).
///
/// To be asked last: an offset that was reduced in another number type may have been rounded out of
/// the interval since.
///
/// \param offset, side  diameters
inline double reduced_offset(double offset, double side) {
  const double reduced = std::remainder(offset, side);  // exact; half a side keeps its sign
  return reduced >= side / 2 ? reduced - side : reduced;
}

}  // namespace zenosphere
