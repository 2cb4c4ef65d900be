#pragma once

#include <array>

#include "model/vec.hpp"

namespace zenosphere {

/// Two unit spheres that fly straight through a sheared box, one seen from the other in the
/// laboratory.
template <int Dim>
struct ShearedFlight {
  Vec<Dim, double> displacement;  ///< from one to the other, in any image, diameters
  Vec<Dim, double> velocity;      ///< relative, diameters/time
  std::array<double, Dim> sides;  ///< of the box, diameters
  double offset;                  ///< of the upper image of the box along x, diameters
  double slide;                   ///< how fast it grows, diameters/time
};

/// Time for which two spheres certainly meet in none of their images; at most `until`.
///
/// One after the other passes the images above it, or below: a pass at a time is looked at, whether
/// the two are near along x, and in space along z, while they are as high as each other. They move
/// straight and at unequal speeds there, since images slide.
///
/// \param until  time from now beyond which it is of no interest
template <int Dim>
double time_apart_sheared(const ShearedFlight<Dim>& flight, double until);

}  // namespace zenosphere
