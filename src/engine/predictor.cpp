#include "engine/predictor.hpp"

#include <algorithm>
#include <limits>

#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

/// Whether sphere i cannot tell the course of j before a collision from that after it: they differ
/// by less than the rounding of places in a box of a million diameters.
template <class Real>
bool hardly_moves(const Grains<Real>& grains, std::int32_t j, std::int32_t i) {
  const Real tiny = std::numeric_limits<Real>::epsilon() * Real(1 << 20);
  return grains.inverse_mass(j) <= tiny * grains.inverse_mass(i);
}

}  // namespace

template <int Dim, class Real>
Predictor<Dim, Real>::Predictor(const System<Dim, Real>& system, const ContactRules<Real>& rules)
    : overlap_(rules.overlap),
      guard_(rules.guard),
      calendar_(system.count()),
      meetings_(static_cast<std::size_t>(system.count())),
      rewind_bound_(system.box(), system.surroundings.acceleration,
                    system.spheres.largest_diameter()) {}

template <int Dim, class Real>
void Predictor<Dim, Real>::find_meetings(const System<Dim, Real>& system, std::int32_t i) {
  const auto neighbours = system.neighbours(i);
  if (const auto two = system.spheres.first_contacts(i, neighbours, system.clock.remainder())) {
    pending(i).set(meeting(system, two->first, two->first_time),
                   meeting(system, two->second, two->second_time), two->meetings <= 2);
  } else {
    pending(i) = in_parts(system, i, neighbours);
  }
  if (system.surroundings.walls && !system.grains().is_immobile(i))
    pending(i).add(with_walls(system, i));
}

template <int Dim, class Real>
void Predictor<Dim, Real>::add_meetings(System<Dim, Real>& system, std::int32_t i,
                                        std::span<const Neighbour> neighbours) {
  const auto two = system.spheres.first_contacts(i, neighbours, system.clock.remainder());
  if (!two) {
    pending(i).add(one_by_one(system, i, neighbours));
  } else if (two->meetings > 0) {
    pending(i).add({meeting(system, two->first, two->first_time),
                    meeting(system, two->second, two->second_time), two->meetings <= 2});
  }
  schedule(system, i);
}

/// The next meetings with many neighbours, of which first_contacts() takes only some at once.
template <int Dim, class Real>
NextMeetings<Real> Predictor<Dim, Real>::in_parts(const System<Dim, Real>& system, std::int32_t i,
                                                  std::span<const Neighbour> neighbours) {
  if (neighbours.size() <= most_first_contacts) return one_by_one(system, i, neighbours);
  NextMeetings<Real> next;
  while (!neighbours.empty()) {
    const auto part = neighbours.first(std::min(most_first_contacts, neighbours.size()));
    neighbours = neighbours.subspan(part.size());
    if (const auto two = system.spheres.first_contacts(i, part, system.clock.remainder())) {
      next.add({meeting(system, two->first, two->first_time),
                meeting(system, two->second, two->second_time), two->meetings <= 2});
    } else {
      next.add(one_by_one(system, i, part));
    }
  }
  return next;
}

template <int Dim, class Real>
NextMeetings<Real> Predictor<Dim, Real>::one_by_one(const System<Dim, Real>& system, std::int32_t i,
                                                    std::span<const Neighbour> neighbours) {
  ahead_.clear();
  system.spheres.find_contacts(i, neighbours, system.clock.remainder(), ahead_);
  return first_ahead(system, i);
}

/// The first of the contacts ahead of i. A sphere that touches another one while they approach
/// overlaps it; one that stands on a wall does not.
template <int Dim, class Real>
NextMeetings<Real> Predictor<Dim, Real>::first_ahead(const System<Dim, Real>& system,
                                                     std::int32_t i) {
  NextMeetings<Real> next;
  if (ahead_.has_overlaps) [[unlikely]] {
    next = with_heavy_partners(system, i);
    apply_overlap_rule(system);
  }
  for (const auto& [partner, time, approach] : ahead_.contacts) {
    const Real then = system.clock.remainder() + time;
    if (!(then < std::numeric_limits<Real>::infinity())) continue;
    const auto wall = system.wall(partner);
    const bool overlaps =
        time <= 0 && (!wall || system.wall_gap(i, *wall, system.clock.remainder()) < 0);
    next.add({then, partner, wall ? 0 : system.spheres[partner].collisions, overlaps});
  }
  return next;
}

/// Takes contacts with immobile or very heavy spheres that seem to overlap out of those ahead,
/// where the partner has predicted them since.
///
/// What hits such a partner makes a meeting stale, but does not move it: looked for again, at the
/// moment of the contact itself, it would be found in the past by rounding as often as not.
template <int Dim, class Real>
NextMeetings<Real> Predictor<Dim, Real>::with_heavy_partners(const System<Dim, Real>& system,
                                                             std::int32_t i) {
  NextMeetings<Real> known;
  std::erase_if(ahead_.contacts, [&](const auto& contact) {
    if (contact.time > 0 || system.wall(contact.partner)) return false;
    if (!hardly_moves(system.grains(), contact.partner, i)) return false;
    const Meeting<Real>& own = pending(contact.partner).first();
    if (own.partner() != i || own.is_overlap() || is_stale(own, system)) return false;
    if (own.time < system.clock.remainder()) return false;
    known.add({own.time, contact.partner, system.spheres[contact.partner].collisions, false});
    return true;
  });
  return known;
}

/// Deals with pairs that overlap by rounding while they approach. Walls let none pass.
template <int Dim, class Real>
void Predictor<Dim, Real>::apply_overlap_rule(const System<Dim, Real>& system) {
  if (overlap_ == OverlapRule::rewind) return limit_rewinds(system);
  for (auto& [partner, time, approach] : ahead_.contacts) {
    if (time > 0) continue;
    time = 0;
    const bool may_pass = overlap_ == OverlapRule::guarded && !system.wall(partner);
    if (may_pass && !(approach < -guard_)) {
      ++overlaps_ignored_;
      time = std::numeric_limits<Real>::infinity();
    }
  }
}

/// Has those collide now whose contact lies further back than rounding can have put it.
template <int Dim, class Real>
void Predictor<Dim, Real>::limit_rewinds(const System<Dim, Real>& system) {
  rewind_bound_.renew(system.spheres, system.clock.remainder(), system.collisions);
  const Real earliest = -rewind_bound_.longest(system.clock.remainder());
  const Real slowest = rewind_bound_.slowest();
  for (auto& contact : ahead_.contacts) {
    const bool is_rounding = contact.time < 0 && contact.approach >= -slowest;
    if (contact.time < earliest || is_rounding) contact.time = 0;
  }
}

template <int Dim, class Real>
bool Predictor<Dim, Real>::is_stale(const Meeting<Real>& meeting,
                                    const System<Dim, Real>& system) const {
  if (system.wall(meeting.partner())) return meeting.partner_collisions != 0;  // not a contact yet
  return system.spheres[meeting.partner()].collisions != meeting.partner_collisions;
}

template <int Dim, class Real>
bool Predictor<Dim, Real>::is_second_known(const NextMeetings<Real>& next,
                                           const System<Dim, Real>& system) const {
  return next.second().has_partner() ? !is_stale(next.second(), system) : next.is_all();
}

template <int Dim, class Real>
void Predictor<Dim, Real>::replace_stale(System<Dim, Real>& system, std::int32_t i) {
  NextMeetings<Real>& next = pending(i);
  const bool is_known = !system.wall(next.first().partner()) && is_second_known(next, system);
  if (!is_known) return predict(system, i);
  next.drop_first();
  schedule(system, i);
}

template <int Dim, class Real>
void Predictor<Dim, Real>::shift_times(const Real& span) {
  rewind_bound_.shift_times(span);
  for (NextMeetings<Real>& next : meetings_) next.shift_times(span);
  calendar_.shift_times(span);
}

template <int Dim, class Real>
void Predictor<Dim, Real>::schedule(System<Dim, Real>& system, std::int32_t i) {
  const Real& meeting = pending(i).first().time;
  calendar_.schedule(
      i, std::min(meeting, system.search.plan_renewal(system.spheres, i, system.clock.remainder(),
                                                      meeting)));
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class Predictor<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
