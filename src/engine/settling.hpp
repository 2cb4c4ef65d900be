#pragma once

#include <cstdint>

#include "model/shear_box.hpp"

namespace zenosphere {

/// How far and for how long a sphere may go until it is settled again.
struct Settling {
  double grain;        ///< unit of places within cells, diameters
  double reach;        ///< from its anchor, diameters
  double distance;     ///< of anchors, diameters: spheres further apart cannot touch
  double window;       ///< time; infinite without shear
  double expiry_unit;  ///< of Anchor::expires, time: a power of two about as long as the clock unit
  double neighbours;   ///< on a list, where the spheres are spread evenly
  bool is_wide;    ///< as wide as the cells, while no sphere has more neighbours than most_alone
  bool is_dilute;  ///< many spheres, most of which fly through their balls and meet nobody there
};

/// Spheres on one list, where balls are as wide as cells: with more of them they are a crowd.
inline constexpr std::int32_t most_alone = 400;

/// What suits so many spheres in a box that is cut into cells. Two spheres that may touch have
/// anchors within 1 + 2 reach, which no cell may be narrower than.
template <int Dim, class Real>
Settling settling_in(const ShearBox<Dim, Real>& box, std::int32_t spheres);

/// The same where they crowd together somewhere, however much room there is elsewhere.
template <int Dim, class Real>
Settling settling_in_crowd(const ShearBox<Dim, Real>& box, std::int32_t spheres);

/// The width that cells should have, in diameters: so that some fifteen neighbours are in reach.
///
/// Wider cells mean longer lists that last longer.
double fitting_cell_width(double volume, std::int64_t spheres, int dimension);

}  // namespace zenosphere
