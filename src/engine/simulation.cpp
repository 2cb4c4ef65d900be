#include "engine/simulation.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

#include "engine/rest.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim, class Real>
Simulation<Dim, Real>::Simulation(const ShearBox<Dim, Real>& box, Configuration<Dim, Real> start,
                                  const ContactRules<Real>& rules,
                                  const Surroundings<Dim, Real>& surroundings)
    : system_(box, std::move(start), surroundings), rules_(rules), predictor_(system_, rules) {
  assert(!rules.table || grains().kind_count() <= rules.table->kinds());
  make_law();
  predictor_.predict_all(system_);
}

template <int Dim, class Real>
Simulation<Dim, Real>::Simulation(const Simulation&) = default;
template <int Dim, class Real>
Simulation<Dim, Real>::Simulation(Simulation&&) noexcept = default;
template <int Dim, class Real>
Simulation<Dim, Real>::~Simulation() = default;

template <int Dim, class Real>
void Simulation<Dim, Real>::make_law() {
  if (!ContactLaw<Dim, Real>::is_needed(rules_, grains())) return;
  law_.emplace(rules_, spheres(), box().clock_unit());
  const bool may_turn = Dim > 1 && rules_.are_rough() && spins().empty();
  if (may_turn) system_.spheres.spins().resize(static_cast<std::size_t>(spheres()));
}

template <int Dim, class Real>
NextCollision<Dim, Real> Simulation<Dim, Real>::collision_until(double until) {
  if (stopped_before_) return NoCollision::overlap;
  Instant<Real> limit = clock().instant(until);
  // Without collisions the caller is asked again about once per list that is rebuilt.
  for (std::int32_t patience = 2 * spheres() + 1024; patience > 0; --patience) {
    const std::int32_t i = predictor_.calendar().earliest();
    prefetcher_.look_ahead(system_, predictor_);
    const bool has_event = i != Calendar<Real>::none;
    // Sliding layers do not rest, nor does what is too slow for the exponents of its squares.
    if (!has_event) at_rest_ = !box().is_sheared() && move_as_one(system_);
    if (at_rest_) return NoCollision::at_rest;
    const Real next =
        has_event ? predictor_.calendar().time(i) : std::numeric_limits<Real>::infinity();
    if (is_past(limit, next)) return NoCollision::up_to_time;
    if (next >= clock().span()) {
      rebase(next, limit);
      limit = clock().instant(until);
      continue;
    }
    const Meeting<Real>& meeting = predictor_.meetings(i).first();
    if (next < meeting.time) {
      rebuild_list(i);
    } else if (predictor_.is_stale(meeting, system_)) {
      replace_stale(i);
    } else if (meeting.is_overlap() && rules_.overlap == OverlapRule::stop && clock().has_begun()) {
      return stop_before(i, meeting);
    } else {
      return collide(i);
    }
  }
  return at_rest_ ? NoCollision::at_rest : NoCollision::for_a_while;
}

/// Whether an event at the clock's remainder `next` comes after `limit`.
///
/// Without shear the clock leaps over whole units to the next event, never just to the limit: where
/// times are shifted in two steps instead of one, rounding leaves a trace.
template <int Dim, class Real>
bool Simulation<Dim, Real>::is_past(const Instant<Real>& limit, const Real& next) const {
  const double left = limit.units - now().units;
  if (left <= 0) return left < 0 || next > limit.remainder;
  if (next < clock().span() || box().is_sheared()) return false;
  return clock().units_to(next) > static_cast<Real>(left);
}

/// Ends the run before the collision of two spheres that overlap. At the start, where spheres that
/// touch have been put so, that is no rounding.
template <int Dim, class Real>
NoCollision Simulation<Dim, Real>::stop_before(std::int32_t i, const Meeting<Real>& meeting) {
  const std::int32_t a = std::min(i, meeting.partner());
  const std::int32_t b = std::max(i, meeting.partner());
  const Neighbour neighbour = system_.neighbour(a, b, meeting.time);
  stopped_before_ = {a, b, gap_at_last_change(a, b, neighbour, meeting.time)};
  return NoCollision::overlap;
}

/// Does the collision that sphere i has pending.
template <int Dim, class Real>
NextCollision<Dim, Real> Simulation<Dim, Real>::collide(std::int32_t i) {
  const Meeting<Real>& meeting = predictor_.meetings(i).first();
  const std::int32_t a = std::min(i, meeting.partner());
  const std::int32_t b = i ^ meeting.partner() ^ a;  // the other one; a branch would be a guess
  const std::optional<int> wall = this->wall(b);
  const Real when = meeting.time;
  NextCollision<Dim, Real> next;
  Collision<Dim, Real>& collision = *next;
  collision.i = a;
  collision.j = b;
  collision.overlapping = meeting.is_overlap();
  const Neighbour neighbour =
      wall ? Neighbour() : system_.search.neighbour(system_.spheres, a, b, when);
  collision.gap_before = gap_at_last_change(a, b, neighbour, when);

  system_.clock.set_to(when);
  // Not copies of now(): to read 16 bytes of which 8 have just been written takes a long wait.
  collision.time = {now().units, when};
  collision.flight = elapsed(last_collision_, {now().units, when}, box().clock_unit());
  collision.number = ++system_.collisions;
  last_collision_ = {now().units, when};
  last_change_ = {now().units, when};
  idle_events_ = 0;
  if (wall) {
    bounce(collision, *wall);
  } else {
    meet(collision, neighbour);
  }
  note_change(collision);
  // A processor begins to look for the second one while it still waits for roots of the first.
  predictor_.find_meetings(system_, a);
  if (!wall) predictor_.find_meetings(system_, b);
  predictor_.schedule(system_, a);
  if (!wall) predictor_.schedule(system_, b);
  return next;
}

/// The collision of two spheres.
template <int Dim, class Real>
void Simulation<Dim, Real>::meet(Collision<Dim, Real>& collision, Neighbour neighbour) {
  auto& a = system_.spheres[collision.i];
  auto& b = system_.spheres[collision.j];
  system_.spheres.advance(collision.i, clock().remainder());
  system_.spheres.advance(collision.j, clock().remainder());
  ++a.collisions;
  ++b.collisions;
  const auto motion = system_.spheres.motion_as_stored(collision.i, neighbour, clock().remainder());
  if (law_) return meet_by_law(collision, motion);
  collision.impact = impact(motion, rules_.restitution);
  const Vector change = collision.impact.normal * -collision.impact.impulse;
  collision.change = change;
  const Vector velocity_a = a.velocity;
  const Vector velocity_b = b.velocity;
  a.velocity += change;
  b.velocity -= change;
  collision.absorbed = a.velocity == velocity_a && b.velocity == velocity_b;
}

/// The same where sizes, masses, friction or a contact model matter.
template <int Dim, class Real>
void Simulation<Dim, Real>::meet_by_law(Collision<Dim, Real>& collision,
                                        const RelativeMotion<Dim, Real>& motion) {
  law_->collide(collision, motion, {grains(), spins()});
  auto& a = system_.spheres[collision.i];
  auto& b = system_.spheres[collision.j];
  const Vector velocity_a = a.velocity;
  const Vector velocity_b = b.velocity;
  a.velocity += collision.change * grains().inverse_mass(collision.i);
  b.velocity -= collision.change * grains().inverse_mass(collision.j);
  const bool turns_i = turn(collision, collision.i);
  const bool turns_j = turn(collision, collision.j);
  collision.absorbed = a.velocity == velocity_a && b.velocity == velocity_b && !turns_i && !turns_j;
}

/// Gives a sphere the spin that it has after a collision. Returns whether it has changed.
template <int Dim, class Real>
bool Simulation<Dim, Real>::turn(const Collision<Dim, Real>& collision, std::int32_t sphere) {
  if (spins().empty()) return false;
  auto& spin = system_.spheres.spins()[static_cast<std::size_t>(sphere)];
  const auto before = spin;
  spin += change_of_spin(collision, sphere);
  return !(spin == before);
}

/// Tells what bounds the steps back of the clock how velocities have changed.
template <int Dim, class Real>
void Simulation<Dim, Real>::note_change(const Collision<Dim, Real>& collision) {
  if (!law_) return predictor_.rewind_bound().note_change(collision.change, clock().remainder());
  for (const std::int32_t sphere : {collision.i, collision.j}) {
    if (wall(sphere)) continue;
    predictor_.rewind_bound().note_change(collision.change * grains().inverse_mass(sphere),
                                          clock().remainder());
  }
}

/// The distance that two spheres, or a sphere and a wall, have to close from the last change of a
/// velocity to their contact, diameters.
template <int Dim, class Real>
Real Simulation<Dim, Real>::gap_at_last_change(std::int32_t i, std::int32_t j, Neighbour neighbour,
                                               const Real& contact) const {
  return system_.gap_to_close(i, j, neighbour, clock().remainder_at(last_change_), contact);
}

/// Rebuilds the list of a sphere; where that is late by rounding, now.
template <int Dim, class Real>
void Simulation<Dim, Real>::rebuild_list(std::int32_t i) {
  ++rebuilds_;
  system_.clock.advance_to(predictor_.calendar().time(i));
  ++idle_events_;
  if (is_idle() && system_.search.is_far_out(system_.spheres, i, clock().remainder())) {
    come_home();
    leap();  // none has come near: at once, if none is near now
  } else {
    const Real& meeting = predictor_.meetings(i).first().time;
    predictor_.add_meetings(system_, i,
                            system_.search.renew(system_.spheres, i, clock().remainder(), meeting));
  }
  if (system_.search.is_crowded()) [[unlikely]] {
    system_.search.renew_in_crowd(system_.spheres, clock().remainder());
    predictor_.predict_all(system_);
  }
  if (is_idle()) look_around();
}

/// Finds what comes in place of a meeting that does not.
template <int Dim, class Real>
void Simulation<Dim, Real>::replace_stale(std::int32_t i) {
  const Meeting<Real>& meeting = predictor_.meetings(i).first();
  ++stale_events_;
  system_.clock.advance_to(meeting.time);
  if (wall(meeting.partner())) ++idle_events_;
  predictor_.replace_stale(system_, i);
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class Simulation<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
