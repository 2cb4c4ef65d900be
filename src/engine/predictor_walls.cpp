// When spheres meet walls.

#include "engine/predictor.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim, class Real>
NextMeetings<Real> Predictor<Dim, Real>::with_walls(const System<Dim, Real>& system,
                                                    std::int32_t i) {
  ahead_.clear();
  const int axis = system.surroundings.walls->axis;
  for (const int wall : {0, 1}) {
    if (system.surroundings.walls->oscillates(wall)) continue;
    const Real outward = wall == 0 ? -1 : 1;
    const Real gap = system.wall_gap(i, wall, system.clock.remainder());
    const Real rate = -outward * system.spheres[i].velocity[axis];
    const auto time =
        closing_time<Real>(gap, rate, -outward * system.surroundings.acceleration[axis]);
    if (time) ahead_.add(system.count() + wall, {*time, gap < 0 && *time <= 0, rate});
  }
  NextMeetings<Real> next = first_ahead(system, i);
  if (!system.surroundings.walls->oscillation) return next;
  const Meeting<Real> meeting = with_oscillating_wall(system, i);
  if (meeting.has_partner()) next.add(meeting);
  return next;
}

/// The next meeting with the wall that oscillates, or the moment at which it has to be looked for
/// again: where the sphere comes within reach of the wall, or has not met it in a period.
template <int Dim, class Real>
Meeting<Real> Predictor<Dim, Real>::with_oscillating_wall(const System<Dim, Real>& system,
                                                          std::int32_t i) const {
  constexpr std::uint32_t to_be_looked_at_again = 1;
  const auto& oscillation = *system.surroundings.walls->oscillation;
  const std::int32_t wall = system.count();
  const int axis = system.surroundings.walls->axis;
  const Real reach = OscillationGap<Real>::out_of_reach(oscillation);
  const Real clearance =
      system.wall_place(i, system.clock.remainder()) - 2 * oscillation.amplitude();
  if (clearance > reach) {
    const auto time = closing_time<Real>(clearance - reach / 2, system.spheres[i].velocity[axis],
                                         system.surroundings.acceleration[axis]);
    if (!time) return {};
    return {system.clock.remainder() + *time, wall, to_be_looked_at_again, false};
  }
  const auto [gap, from] = system.oscillating_gap(i);
  const Real since = system.clock.remainder() - from;
  const auto due = gap.due(since);
  const bool overlaps = due.is_contact && !(due.span > since) && gap.at(since).gap < 0;
  return {from + due.span, wall, due.is_contact ? 0 : to_be_looked_at_again, overlaps};
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                                \
  template NextMeetings<Real> Predictor<Dim, Real>::with_walls(const System<Dim, Real>&, \
                                                               std::int32_t);
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
