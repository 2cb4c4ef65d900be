// The loop of a run, which is compiled with all optimizations.

#include "model/instantiate.hpp"
#include "run/observed.hpp"

namespace zenosphere {

template <int Dim, class Real>
Halt Observed<Dim, Real>::go_on(const Stretch& stretch) {
  Halt halt;
  const double sure_time = time_before_the_end();
  bool is_over = what_ends().has_value();
  while (!is_over && simulation_.collisions() < stretch.collisions &&
         halt.rounds < stretch.rounds && !halt.is_waiting) {
    ++halt.rounds;
    if (const auto next = simulation_.collision_until(stretch.time)) {
      observers_.observe(*next, simulation_);
      if (samples_) samples_->observe(*next, simulation_);
      if (recorder_) recorder_->observe(*next);
      rows_.observe(*next);
      is_over = may_end_with_a_collision(sure_time) && what_ends();
    } else {
      halt.is_waiting = is_quiet(next.error());
      is_over = what_ends().has_value();
    }
  }
  return halt;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template Halt Observed<Dim, Real>::go_on(const Stretch&);
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
