// The kicks of random driving, which are not in the log, between its collisions.
#include <cmath>

#include "model/instantiate.hpp"
#include "model/rewind.hpp"
#include "verify/replay.hpp"

namespace zenosphere::verify {

template <int Dim>
void Replay<Dim>::kick_until(double time) {
  while (kicks_.next() < time) {
    const Number when = kicks_.next();
    const auto changes = kicks_.take();
    last_kick_ = last_change_ = when;
    if (!has_start_) continue;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      Body<Dim>& body = bodies_[i];
      body = motion_.moved(body, when);
      body.velocity += changes[i];
      motion_.add_momentum(changes[i]);
      // The mean of all changes is taken off, a sum of N rounded terms.
      body.velocity_error += 64 * motion_.rounding() * (length(body.velocity) + length(changes[i]));
    }
  }
}

/// Whether the stored times do not tell if a collision came before a kick or after it.
template <int Dim>
bool Replay<Dim>::is_beside_a_kick(double time) const {
  const Number distance = std::min<Number>(time - last_kick_, kicks_.next() - time);
  return distance <= 4 * motion_.clock_error(time);
}

/// Whether `rewind` may have set the clock back from behind the next kick, by which the spheres fly
/// already, while the log comes to its time only later.
template <int Dim>
bool Replay<Dim>::may_be_set_back_behind_a_kick(const CollisionRow& row) const {
  const bool overlapped = (row.flags & collision_flag::overlap) != 0;
  if (!overlapped || values_.collision.overlap != OverlapRule::rewind) return false;
  const Number way = longest_way_back(motion_.longest_side(), motion_.rounding(),
                                      Number(grains_.largest_diameter()));
  return (kicks_.next() - row.time) * kicks_.largest() <= way;
}

#define ZENOSPHERE_INSTANTIATE(Dim)                          \
  template void Replay<Dim>::kick_until(double);             \
  template bool Replay<Dim>::is_beside_a_kick(double) const; \
  template bool Replay<Dim>::may_be_set_back_behind_a_kick(const CollisionRow&) const;
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere::verify
