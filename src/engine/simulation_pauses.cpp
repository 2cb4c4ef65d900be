// What is done to a simulation between its collisions: it waits, and it is kicked.

#include <algorithm>
#include <cassert>
#include <limits>

#include "engine/simulation.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim, class Real>
void Simulation<Dim, Real>::wait_until(double time) {
  const Instant<Real> wanted = instant_at(time, box().clock_unit());
  if (!box().is_sheared() && wanted.units > now_.units) {
    rebase(std::numeric_limits<Real>::infinity(), wanted);
  }
  if (now_.units == wanted.units) now_.remainder = std::max(now_.remainder, wanted.remainder);
}

template <int Dim, class Real>
void Simulation<Dim, Real>::kick(const std::vector<Vector>& changes) {
  assert(changes.size() == meetings_.size());
  for (std::int32_t i = 0; i < spheres(); ++i) {
    spheres_.advance(spheres_[i], now_.remainder);
    spheres_[i].velocity += changes[static_cast<std::size_t>(i)];
  }
  at_rest_ = false;
  last_change_ = now_;
  rewind_bound_.forget();
  for (std::int32_t i = 0; i < spheres(); ++i) predict(i);
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                  \
  template void Simulation<Dim, Real>::wait_until(double); \
  template void Simulation<Dim, Real>::kick(const std::vector<Vec<Dim, Real>>&);
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
