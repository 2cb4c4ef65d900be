#pragma once

#include <optional>
#include <vector>

#include "collapse/dissection.hpp"

namespace zenosphere {

/// One collision of a cluster, in the order in which they came.
template <class Real>
struct ClusterStep {
  int pair = 0;           ///< which of the cluster's pairs
  Real time = 0;          ///< from the moment of the dissection on, <= 0
  Real flight = 0;        ///< since the cluster's collision before
  Real gap = 0;           ///< that was closed, diameters
  Real normal_speed = 0;  ///< diameters/time
};

/// The geometric decay of a cluster's collisions: factors per collision, over the last 64 of them.
///
/// For flights the duration of whole cycles counts, from a collision of a pair to its next one.
/// Gaps and durations are used down to 100 000 ulps, speeds as long as one of the two is. The
/// collapse time is that of a geometric series of cycles: t + F Q/(1 - Q) with F the last cycle of
/// a pair and Q its ratio to the one before.
///
/// Source: the factors are eigenvalues of the map of a cycle, Bernu & Mazighi, J. Phys. A 23 (1990)
/// 5745; the sum is Aitken's extrapolation.
///
/// \param reading  the largest remainder of the simulation's clock, at least its unit: its rounding
///                 is that of a number of this size
template <class Real>
Decay decay_of(const std::vector<ClusterStep<Real>>& steps, const Real& reading);

/// The factors of balls on a line that collapse, all odd pairs and all even pairs in turn; nothing
/// where they do not collapse: restitution > tan^2[(pi/4)(1 - 2/N)].
///
/// In a round of one kind, which is (N - 1)/2 collisions, speeds and gaps shrink by the larger and
/// the smaller root of x^2 - (1 + e) cos(pi/N) x + e = 0.
/// Source: Bernu & Mazighi, J. Phys. A 23 (1990) 5745.
///
/// \param balls        N >= 2
/// \param restitution  in [0, 1]
std::optional<ChainFactors> chain_factors(int balls, double restitution);

}  // namespace zenosphere
