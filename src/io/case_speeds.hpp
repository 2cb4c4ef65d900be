#pragma once

#include <optional>
#include <string>
#include <vector>

namespace zenosphere::case_format {

/// Speeds between which the numbers of a run stay numbers [diameters/time].
///
/// The power that collisions dissipate is a product of three speeds, the largest that is taken of
/// them; it and all others are told as `double` in every precision, whose range is 2e-308 to 2e308.
/// Between these limits there is room for 10^7 spheres and for what a run heats up and cools down.
inline constexpr double slowest = 1e-100;
inline constexpr double fastest = 1e100;

/// What is wrong with the velocities of a start, as in `sphere 3 has the speed 1e+155 (...)`, or
/// nothing.
///
/// \param velocities  N x D, row-major, diameters/time
std::optional<std::string> wrong_speed(const std::vector<double>& velocities, int dimension);

}  // namespace zenosphere::case_format
