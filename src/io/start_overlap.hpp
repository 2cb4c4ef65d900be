#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace zenosphere {

/// Distance by which spheres may overlap each other or a wall at the start, diameters: what
/// rounding leaves of a contact.
inline constexpr double touching = 1e-12;

/// Two spheres and the distance of their centres.
struct OverlappingPair {
  std::int64_t i;
  std::int64_t j;  ///< > i
  double distance;
};

/// The pair of unit spheres nearer than a diameter, the first by i and then j, or nothing.
///
/// \param positions  N x D, row-major, every component in [0, L), diameters
/// \param sides      D; along each but `closed` the box is periodic and longer than two diameters
/// \param closed     the axis that ends at walls, from 0, or none
std::optional<OverlappingPair> first_overlap(const std::vector<double>& positions,
                                             const std::vector<double>& sides,
                                             std::optional<int> closed);

}  // namespace zenosphere
