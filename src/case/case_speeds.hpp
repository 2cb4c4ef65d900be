#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace zenosphere::case_format {

/// Speeds between which the numbers of a run stay numbers [diameters/time].
///
/// The power that collisions dissipate is a product of three speeds, the largest that is taken of
/// them; it and all others are told as `double` in every precision, whose range is 2e-308 to 2e308.
/// Averages are per volume and time besides: 1e27 and 1e84 in the largest box at the lowest speed.
/// Between these limits there is room for that, for 10^7 spheres, and for what a run heats up and
/// cools down.
inline constexpr double slowest = 1e-75;
inline constexpr double fastest = 1e75;

/// What is wrong with the velocities of a start, as in `sphere 3 has the speed 1e+155 (...)`, or
/// nothing.
///
/// \param velocities  N x D, row-major, diameters/time
std::optional<std::string> wrong_speed(const std::vector<double>& velocities, int dimension);

/// The rows of positions or velocities of a case, one behind the other.
std::vector<double> flat(const std::vector<std::vector<double>>& rows);

/// How fast the spheres of a start are beside each other and towards walls, diameters/time: the
/// thermal speed if all that they share is taken off, a common velocity along periodic axes and the
/// profile of the shear. 0: nothing is left, or there are none.
///
/// \param positions, velocities  N x D, row-major, diameters and diameters/time, laboratory
double thermal_speed(const Case& values, const std::vector<double>& positions,
                     const std::vector<double>& velocities);

}  // namespace zenosphere::case_format
