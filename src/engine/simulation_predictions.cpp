// What a simulation foretells: whom a sphere meets next.

#include <algorithm>

#include "engine/simulation.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim, class Real>
void Simulation<Dim, Real>::predict(std::int32_t i) {
  spheres_.advance(spheres_[i], now_.remainder);
  predict_from_here(i);
}

/// Predicts what comes next for a sphere that is stored as it is now.
template <int Dim, class Real>
void Simulation<Dim, Real>::predict_from_here(std::int32_t i) {
  ContactsAhead<Real>& ahead = ahead_;
  ahead.clear();
  spheres_.find_contacts(i, spheres_.neighbours(i), now_.remainder, ahead);
  if (surroundings_.walls) find_walls(i, ahead);
  if (ahead.has_overlaps) [[unlikely]]
    apply_overlap_rule(ahead);
  const FirstTwo two = spheres_.first_two(ahead, now_.remainder);
  meetings(i).set(meeting(i, ahead, two.first), meeting(i, ahead, two.second), two.meetings <= 2);
  schedule(i);
}

/// Adds the meetings with new neighbours to those that are known.
template <int Dim, class Real>
void Simulation<Dim, Real>::predict_new(std::int32_t i, std::span<const Neighbour> neighbours) {
  ContactsAhead<Real>& ahead = ahead_;
  ahead.clear();
  spheres_.find_contacts(i, neighbours, now_.remainder, ahead);
  if (ahead.has_overlaps) [[unlikely]]
    apply_overlap_rule(ahead);
  for (std::size_t k = 0; k < ahead.count; ++k) {
    if (!(ahead.time[k] < std::numeric_limits<Real>::infinity())) continue;
    meetings(i).add(meeting(i, ahead, static_cast<int>(k)));
  }
  schedule(i);
}

template <int Dim, class Real>
void Simulation<Dim, Real>::find_walls(std::int32_t i, ContactsAhead<Real>& ahead) const {
  const int axis = surroundings_.walls->axis;
  for (const int wall : {0, 1}) {
    const Real outward = wall == 0 ? -1 : 1;
    const Real gap = wall_gap(i, wall, now_.remainder);
    const Real rate = -outward * spheres_[i].velocity[axis];
    const auto time = closing_time<Real>(gap, rate, -outward * surroundings_.acceleration[axis]);
    if (time) ahead.add(spheres() + wall, {*time, gap < 0 && *time <= 0, rate});
  }
}

/// Deals with pairs that overlap by rounding while they approach. Walls let nobody pass.
template <int Dim, class Real>
void Simulation<Dim, Real>::apply_overlap_rule(ContactsAhead<Real>& ahead) {
  if (rules_.overlap == OverlapRule::rewind) return;
  for (std::size_t k = 0; k < ahead.count; ++k) {
    if (ahead.time[k] > 0) continue;
    ahead.time[k] = 0;
    const bool may_pass = rules_.overlap == OverlapRule::guarded && !wall(ahead.partner[k]);
    if (may_pass && !(ahead.approach[k] < -rules_.guard)) {
      ++overlaps_ignored_;
      ahead.time[k] = std::numeric_limits<Real>::infinity();
    }
  }
}

/// One of the contacts of i as a meeting; number -1: with nobody. A sphere that touches another one
/// while they approach overlaps it; one that stands on a wall does not.
template <int Dim, class Real>
Meeting<Real> Simulation<Dim, Real>::meeting(std::int32_t i, const ContactsAhead<Real>& ahead,
                                             int number) const {
  if (number < 0) return {};
  const auto k = static_cast<std::size_t>(number);
  const Real time = now_.remainder + ahead.time[k];
  const std::int32_t partner = ahead.partner[k];
  const bool is_due = ahead.time[k] <= 0;
  if (const auto wall = this->wall(partner)) {
    return {time, partner, 0, is_due && wall_gap(i, *wall, now_.remainder) < 0};
  }
  return {time, partner, spheres_[partner].collisions, is_due};
}

template <int Dim, class Real>
bool Simulation<Dim, Real>::is_stale(const Meeting<Real>& meeting) const {
  if (wall(meeting.partner())) return false;
  return spheres_[meeting.partner()].collisions != meeting.partner_collisions;
}

/// Looks for what comes in place of the first meeting of a sphere, whose partner has met somebody
/// else.
template <int Dim, class Real>
void Simulation<Dim, Real>::go_stale(std::int32_t i) {
  NextMeetings<Real>& next = meetings(i);
  ++stale_events_;
  now_.remainder = std::max(now_.remainder, next.first().time);
  const bool is_known = next.second().is_with_anybody() ? !is_stale(next.second()) : next.is_all();
  if (!is_known) return predict(i);
  next.drop_first();
  schedule(i);
}

template <int Dim, class Real>
void Simulation<Dim, Real>::schedule(std::int32_t i) {
  const Real& meeting = meetings(i).first().time;
  calendar_.schedule(i, std::min(meeting, spheres_.unsettled_at(i, now_.remainder, meeting)));
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                                     \
  template void Simulation<Dim, Real>::predict(std::int32_t);                                 \
  template void Simulation<Dim, Real>::predict_from_here(std::int32_t);                       \
  template void Simulation<Dim, Real>::predict_new(std::int32_t, std::span<const Neighbour>); \
  template bool Simulation<Dim, Real>::is_stale(const Meeting<Real>&) const;                  \
  template void Simulation<Dim, Real>::go_stale(std::int32_t);                                \
  template void Simulation<Dim, Real>::schedule(std::int32_t);
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
