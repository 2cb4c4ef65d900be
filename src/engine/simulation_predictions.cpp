// What a simulation foretells: whom a sphere meets next.

#include <algorithm>
#include <limits>

#include "engine/simulation.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim, class Real>
void Simulation<Dim, Real>::predict(std::int32_t i) {
  spheres_.advance(spheres_[i], now_.remainder);
  look_ahead(i);
  schedule(i);
}

/// Finds the next meetings of a sphere that is stored as it is now.
template <int Dim, class Real>
void Simulation<Dim, Real>::look_ahead(std::int32_t i) {
  const auto neighbours = spheres_.neighbours(i);
  if (const auto two = spheres_.first_contacts(i, neighbours, now_.remainder)) {
    meetings(i).set(meeting(two->first, two->first_time), meeting(two->second, two->second_time),
                    two->meetings <= 2);
  } else {
    meetings(i) = in_parts(i, neighbours);
  }
  if (surroundings_.walls && !grains().is_immobile(i)) meetings(i).add(with_walls(i));
}

/// Adds the meetings with new neighbours to those that are known.
template <int Dim, class Real>
void Simulation<Dim, Real>::predict_new(std::int32_t i, std::span<const Neighbour> neighbours) {
  if (const auto two = spheres_.first_contacts(i, neighbours, now_.remainder)) {
    meetings(i).add({meeting(two->first, two->first_time), meeting(two->second, two->second_time),
                     two->meetings <= 2});
  } else {
    meetings(i).add(one_by_one(i, neighbours));
  }
  schedule(i);
}

/// The next meetings with many neighbours, of which first_contacts() takes only some at once.
template <int Dim, class Real>
NextMeetings<Real> Simulation<Dim, Real>::in_parts(std::int32_t i,
                                                   std::span<const Neighbour> neighbours) {
  if (neighbours.size() <= most_first_contacts) return one_by_one(i, neighbours);
  NextMeetings<Real> next;
  while (!neighbours.empty()) {
    const auto part = neighbours.first(std::min(most_first_contacts, neighbours.size()));
    neighbours = neighbours.subspan(part.size());
    if (const auto two = spheres_.first_contacts(i, part, now_.remainder)) {
      next.add({meeting(two->first, two->first_time), meeting(two->second, two->second_time),
                two->meetings <= 2});
    } else {
      next.add(one_by_one(i, part));
    }
  }
  return next;
}

/// With a sphere that does not overlap, or -1: with nobody.
template <int Dim, class Real>
Meeting<Real> Simulation<Dim, Real>::meeting(std::int32_t j, const Real& time) const {
  return j < 0 ? Meeting<Real>() : Meeting<Real>(time, j, spheres_[j].collisions, false);
}

template <int Dim, class Real>
NextMeetings<Real> Simulation<Dim, Real>::one_by_one(std::int32_t i,
                                                     std::span<const Neighbour> neighbours) {
  ahead_.clear();
  spheres_.find_contacts(i, neighbours, now_.remainder, ahead_);
  return first_ahead(i);
}

/// The first of the contacts ahead of i. A sphere that touches another one while they approach
/// overlaps it; one that stands on a wall does not.
template <int Dim, class Real>
NextMeetings<Real> Simulation<Dim, Real>::first_ahead(std::int32_t i) {
  NextMeetings<Real> next;
  if (ahead_.has_overlaps) [[unlikely]] {
    next = with_heavy_partners(i);
    apply_overlap_rule();
  }
  for (const auto& [partner, time, approach] : ahead_.contacts) {
    const Real then = now_.remainder + time;
    if (!(then < std::numeric_limits<Real>::infinity())) continue;
    const auto wall = this->wall(partner);
    const bool overlaps = time <= 0 && (!wall || wall_gap(i, *wall, now_.remainder) < 0);
    next.add({then, partner, wall ? 0 : spheres_[partner].collisions, overlaps});
  }
  return next;
}

/// Takes contacts with immobile or very heavy spheres that seem to overlap out of those ahead,
/// where the partner has foretold them since.
///
/// What hits such a partner makes a meeting stale, but does not move it: looked for again, at the
/// moment of the contact itself, it would be found in the past by rounding as often as not.
template <int Dim, class Real>
NextMeetings<Real> Simulation<Dim, Real>::with_heavy_partners(std::int32_t i) {
  NextMeetings<Real> known;
  std::erase_if(ahead_.contacts, [&](const auto& contact) {
    if (contact.time > 0 || wall(contact.partner)) return false;
    if (!hardly_moves(contact.partner, i)) return false;
    const Meeting<Real>& own = meetings(contact.partner).first();
    if (own.partner() != i || own.is_overlap() || is_stale(own)) return false;
    if (own.time < now_.remainder) return false;
    known.add({own.time, contact.partner, spheres_[contact.partner].collisions, false});
    return true;
  });
  return known;
}

/// Whether sphere i cannot tell the course of j before a collision from that after it: they differ
/// by less than the rounding of places in a box of a million diameters.
template <int Dim, class Real>
bool Simulation<Dim, Real>::hardly_moves(std::int32_t j, std::int32_t i) const {
  const Real tiny = std::numeric_limits<Real>::epsilon() * Real(1 << 20);
  return grains().inverse_mass(j) <= tiny * grains().inverse_mass(i);
}

/// Deals with pairs that overlap by rounding while they approach. Walls let nobody pass.
template <int Dim, class Real>
void Simulation<Dim, Real>::apply_overlap_rule() {
  if (rules_.overlap == OverlapRule::rewind) return limit_rewinds();
  for (auto& [partner, time, approach] : ahead_.contacts) {
    if (time > 0) continue;
    time = 0;
    const bool may_pass = rules_.overlap == OverlapRule::guarded && !wall(partner);
    if (may_pass && !(approach < -rules_.guard)) {
      ++overlaps_ignored_;
      time = std::numeric_limits<Real>::infinity();
    }
  }
}

/// Has those collide now whose contact lies further back than rounding can have put it.
template <int Dim, class Real>
void Simulation<Dim, Real>::limit_rewinds() {
  rewind_bound_.renew(spheres_, now_.remainder, collisions_);
  const Real earliest = -rewind_bound_.longest(now_.remainder);
  const Real slowest = rewind_bound_.slowest();
  for (auto& contact : ahead_.contacts) {
    const bool is_rounding = contact.time < 0 && contact.approach >= -slowest;
    if (contact.time < earliest || is_rounding) contact.time = 0;
  }
}

template <int Dim, class Real>
bool Simulation<Dim, Real>::is_stale(const Meeting<Real>& meeting) const {
  if (wall(meeting.partner())) return meeting.partner_collisions != 0;  // not a contact yet
  return spheres_[meeting.partner()].collisions != meeting.partner_collisions;
}

/// Whether the second meeting takes the place of the first: or nobody, where that was all.
template <int Dim, class Real>
bool Simulation<Dim, Real>::is_second_known(const NextMeetings<Real>& next) const {
  return next.second().is_with_anybody() ? !is_stale(next.second()) : next.is_all();
}

/// Looks for what comes in place of the first meeting of a sphere, whose partner has met somebody
/// else; or is a wall that the sphere is only now within reach of.
template <int Dim, class Real>
void Simulation<Dim, Real>::go_stale(std::int32_t i) {
  NextMeetings<Real>& next = meetings(i);
  ++stale_events_;
  now_.remainder = std::max(now_.remainder, next.first().time);
  if (wall(next.first().partner())) {
    ++idle_events_;
    return predict(i);
  }
  if (!is_second_known(next)) return predict(i);
  next.drop_first();
  schedule(i);
}

template <int Dim, class Real>
void Simulation<Dim, Real>::schedule(std::int32_t i) {
  const Real& meeting = meetings(i).first().time;
  calendar_.schedule(i, std::min(meeting, spheres_.unsettled_at(i, now_.remainder, meeting)));
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                                     \
  template NextMeetings<Real> Simulation<Dim, Real>::first_ahead(std::int32_t);               \
  template void Simulation<Dim, Real>::predict(std::int32_t);                                 \
  template void Simulation<Dim, Real>::look_ahead(std::int32_t);                              \
  template void Simulation<Dim, Real>::predict_new(std::int32_t, std::span<const Neighbour>); \
  template bool Simulation<Dim, Real>::is_stale(const Meeting<Real>&) const;                  \
  template bool Simulation<Dim, Real>::is_second_known(const NextMeetings<Real>&) const;      \
  template void Simulation<Dim, Real>::go_stale(std::int32_t);                                \
  template void Simulation<Dim, Real>::schedule(std::int32_t);
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
