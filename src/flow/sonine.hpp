#pragma once

#include <span>

#include "model/vec.hpp"

namespace zenosphere {

/// How far velocities are from a Maxwellian: a2 = D <v^4> / ((D + 2) <v^2>^2) - 1 of velocities v
/// relative to their mean, the second coefficient of an expansion in Sonine polynomials.
///
/// The moments are corrected for the mean that has been taken off: of Maxwellian velocities the
/// expectation is 0, however few they are. 0 where nothing moves.
///
/// \param velocities  two or more, of spheres of one mass
/// Source: van Noije & Ernst, Granular Matter 1 (1998) 57.
template <int Dim>
double second_sonine_coefficient(std::span<const Vec<Dim, double>> velocities);

}  // namespace zenosphere
