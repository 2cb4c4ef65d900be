#pragma once

#include "campaign/boundary_rounds.hpp"
#include "campaign/campaign.hpp"

namespace zenosphere {

/// What came of a search: the progress of its runs, and what was found.
struct SearchResult {
  SweepProgress progress;
  std::vector<FoundBoundary> found;
};

/// Runs a search round by round until every point has its answer, or it is interrupted.
///
/// Throws OutputError where the store cannot be written.
SearchResult run_search(SweepStore& store, const Sweep& sweep, Workers& workers,
                        const SweepOptions& options);

}  // namespace zenosphere
