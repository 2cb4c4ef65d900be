#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include "campaign/store.hpp"

namespace zenosphere {

/// What a sweep would do, before it does it.
struct SweepPlan {
  RunCounts counts;
  double seconds_per_run = 0;  ///< on one core
  std::string source;          ///< where that comes from, for people
  /// Wall time of what is left to do [s].
  double seconds(std::size_t workers) const;
};

/// The plan of a sweep, with an estimate of the time it takes.
///
/// At a point of the grid where three runs are done, or one that went on to its limits, their mean
/// counts for the others there. (The runs that are done first are those that ended early.) For the
/// rest it is the mean of probes: a few runs spread over what is left, each for half a second at
/// most and stretched to its limits, so that a run which would collapse later than that, but before
/// its limits, takes less. Of a search it is the mean of all runs done, or else of probes.
///
/// \param store  none: nothing has been done
/// Throws InputError where the store holds another sweep.
SweepPlan plan_of(const Sweep& sweep, const std::optional<std::string>& store,
                  const std::atomic<bool>* interrupt);

}  // namespace zenosphere
