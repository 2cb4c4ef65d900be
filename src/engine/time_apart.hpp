#pragma once

#include <array>
#include <limits>

#include "model/vec.hpp"

namespace zenosphere {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// Two unit spheres that fly straight through a box at rest, one seen from the other.
template <int Dim>
struct StraightFlight {
  Vec<Dim, double> displacement;    ///< from one to the other, in any image, diameters
  Vec<Dim, double> velocity;        ///< relative, diameters/time
  double speed;                     ///< of the faster one in the box, diameters/time
  std::array<double, Dim> periods;  ///< sides of the box, diameters; infinity: not periodic
};

/// No flight is foreseen over more diameters: from there on places would be rounded by 1e-3.
inline constexpr double longest_foreseen = 0x1p-12 / std::numeric_limits<double>::epsilon();

/// Time for which two spheres certainly meet in none of their images; 0 where they may meet soon,
/// or where the box is narrow. Beyond longest_foreseen nothing is certain.
///
/// However many boxes they cross, that takes a logarithm of their number in two dimensions; in
/// three it takes one such search for each pass that is near along one of the axes across.
///
/// \param until     time from now beyond which it is of no interest
/// \param searches  such passes that are looked at, at most: what lies behind is not certain
/// Source: gaps and steps of n x modulo 1: Slater, Proc. Camb. Phil. Soc. 63 (1967) 1115; found
/// here by Euclid's algorithm with integers.
template <int Dim>
double time_apart(const StraightFlight<Dim>& flight, double until, int searches);

}  // namespace zenosphere
