#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

#include "campaign/store.hpp"
#include "campaign/workers.hpp"

namespace zenosphere {

/// How far a sweep has come: what its progress line shows.
struct SweepProgress {
  RunCounts counts;             ///< of the store
  std::size_t running = 0;      ///< runs in work now
  std::int64_t ended_here = 0;  ///< runs that ended since this process began
  double wall_seconds = 0;      ///< since then
};

/// What surrounds a sweep.
struct SweepOptions {
  const std::atomic<bool>* interrupt = nullptr;             ///< set from outside to end early
  std::function<void(const SweepProgress&)> on_progress{};  ///< called a few times a second
};

/// Hands out the runs of a store that are still to be done, and records what becomes of them.
///
/// An interrupt ends the runs in work, which stay to be done; all else is recorded. Memory does not
/// grow with the number of runs.
/// Throws OutputError where the store cannot be written.
SweepProgress run_sweep(SweepStore& store, Workers& workers, const SweepOptions& options);

}  // namespace zenosphere
