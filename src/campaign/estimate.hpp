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

/// The plan of a sweep.
///
/// Seconds come from the runs that a store holds already, or else from probes: a few runs spread
/// over the grid, each for half a second at most and stretched to its limits. A run that would
/// collapse earlier than its limits takes less.
///
/// \param store  none: nothing has been done
/// Throws InputError where the store holds another sweep.
SweepPlan plan_of(const Sweep& sweep, const std::optional<std::string>& store,
                  const std::atomic<bool>* interrupt);

}  // namespace zenosphere
