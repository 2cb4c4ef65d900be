#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace zenosphere {

/// One collision as the search for approaches sees it.
struct DepthRow {
  std::int32_t i = 0;
  std::int32_t j = 0;     ///< > i; the number of spheres and one more stand for the two walls
  double depth = 0;       ///< decades of the gap that was closed: -log10(gap / diameter)
  bool at_limit = false;  ///< the gap is at or below the resolution of the number type
};

/// How gaps fall where they fall by one law: a straight line of decades against collisions.
struct SteadyFall {
  double decades = 0;        ///< that the gaps fell by it, up to the end of the approach
  double per_collision = 0;  ///< decades, mean; the gap is multiplied by 10^-per_collision
  double unevenness = 1;     ///< largest over smallest rate in the four quarters of the stretch
};

/// Gaps of one cluster that fall together.
///
/// Depths are medians over the last collisions of the cluster, about four for each of its pairs:
/// in a long row the gaps of one round differ by twenty decades and more.
struct ClusterApproach {
  std::size_t first = 0;  ///< row at which the gaps begin to fall
  std::size_t last = 0;   ///< row of the lowest median, or the first whose gap is at the limit
  std::size_t end = 0;    ///< row behind the last that belongs to it
  double from = 0;        ///< median depth at `first`, decades
  double to = 0;          ///< likewise at `last`
  double deepest = 0;     ///< decades of the smallest gap above the limit
  bool is_spent = false;  ///< gaps reach the limit: the digits of the type are used up
  std::optional<double> reopened_to{};  ///< median depth after it, where the gaps have grown again
  /// Share of the decades, from 8 or where it begins to the limit, that a gap was seen in.
  double visited = 0;
  std::optional<SteadyFall> steady{};  ///< of at least four decades
};

/// The clusters whose spheres meet again and again at small gaps: connected by pairs that were seen
/// at least three times deeper than `least_depth`.
///
/// \param spheres  of the system; a wall connects no spheres
/// \return         spheres of each, ascending
std::vector<std::vector<std::int32_t>> deep_clusters(std::span<const DepthRow> rows,
                                                     double least_depth, std::int32_t spheres);

/// The places of those rows whose contact is within the cluster, or of one of it with a wall.
///
/// \param cluster  spheres, ascending
std::vector<std::size_t> rows_of_cluster(std::span<const DepthRow> rows,
                                         std::span<const std::int32_t> cluster,
                                         std::int32_t spheres);

/// Collisions over which depths of a cluster are smoothed: four for each pair that is deeper than
/// `least_depth`, from 4 to 512.
std::size_t smoothing_window(std::span<const DepthRow> cluster_rows, double least_depth);

/// The median of the last `window` depths up to each row.
std::vector<double> smoothed_depths(std::span<const DepthRow> cluster_rows, std::size_t window);

/// The approaches in the collisions of one cluster, in order.
///
/// One ends where the median depth has come down from its peak by a quarter of the type's decades
/// (at least 4, at most 10), or by a fifth of the peak's if that is more. Smaller steps belong to
/// it: a row is compressed, gives way, and is compressed again. Approaches whose gaps stay above
/// `least_depth` are none.
///
/// \param limit  decades of the type's resolution: 16 for `double`
std::vector<ClusterApproach> approaches_of(std::span<const DepthRow> cluster_rows, double limit,
                                           double least_depth);

/// Gaps below 1e-8 diameters do not come by chance twice in a row; those of a cold lattice are
/// 1e-5.
inline constexpr double least_approach_depth = 8;

}  // namespace zenosphere
