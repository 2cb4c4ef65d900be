// The loop of a run, which is compiled with all optimizations.

#include "model/instantiate.hpp"
#include "run/observed.hpp"

namespace zenosphere {

template <int Dim, class Real>
Halt Observed<Dim, Real>::go_on(const Stretch& stretch) {
  Halt halt;
  while (!what_ends() && simulation_.collisions() < stretch.collisions &&
         halt.rounds < stretch.rounds && !halt.is_waiting) {
    ++halt.rounds;
    if (const auto next = simulation_.collision_until(stretch.time)) {
      observers_.observe(*next, simulation_);
      if (samples_) samples_->observe(*next, simulation_);
      if (recorder_) recorder_->observe(*next);
      rows_.observe(*next);
    } else {
      halt.is_waiting = is_quiet(next.error());
    }
  }
  return halt;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template Halt Observed<Dim, Real>::go_on(const Stretch&);
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
