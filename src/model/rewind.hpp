#pragma once

#include <cmath>
#include <limits>

namespace zenosphere {

/// How far along its course `rewind` may set a sphere back, diameters.
///
/// A place in a box of side L is stored to about an ulp, epsilon L; what a flight, an image and the
/// difference of two places round makes delta = 4 epsilon L, the depth of an overlap that rounding
/// can have made. Spheres that graze each other stay that deep for sqrt(2 delta) of their relative
/// path: so far back, and no further, contact may lie. In the paper's cases one rewind in a hundred
/// is longer than sqrt(2 delta) at the fastest speed, one in ten thousand than 10 of it, and the
/// longest of 3e5 is 26, in 53, 64 and 113 bits alike: pairs that graze more slowly than the
/// fastest sphere flies. At 32 these runs keep each bit.
///
/// Of spheres of other sizes the path is sqrt(2 delta) of their mean diameter.
///
/// \param longest_side  of the box, diameters
/// \param epsilon       of the number type
/// \param sigma         largest diameter
/// Source: docs/decisions/0016-rewind-within-the-digits.md.
template <class Real>
Real longest_way_back(const Real& longest_side,
                      const Real& epsilon = std::numeric_limits<Real>::epsilon(),
                      const Real& sigma = Real(1)) {
  using std::sqrt;
  const Real depth = 4 * epsilon * longest_side;
  return 32 * sqrt(static_cast<Real>(2 * depth * sigma));
}

}  // namespace zenosphere
