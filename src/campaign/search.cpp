#include "campaign/search.hpp"

namespace zenosphere {

SearchResult run_search(SweepStore& store, const Sweep& sweep, Workers& workers,
                        const SweepOptions& options) {
  BoundaryRounds rounds = store.rounds(sweep);
  SearchResult result;
  for (bool goes_on = true; goes_on;) {
    const SweepProgress round = run_sweep(store, workers, options);
    result.progress.counts = round.counts;
    result.progress.ended_here += round.ended_here;
    result.progress.wall_seconds += round.wall_seconds;
    if (round.counts.pending > 0) break;  // interrupted
    goes_on = rounds.place_next();
  }
  result.found = rounds.found();
  return result;
}

}  // namespace zenosphere
