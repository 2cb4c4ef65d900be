#include "engine/simulation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

/// Not at the start any more, where spheres that touch have been put so: that is no rounding.
template <class Real>
bool has_begun(const Instant<Real>& now) {
  return now.units > 0 || now.remainder > 0;
}

}  // namespace

template <int Dim, class Real>
Simulation<Dim, Real>::Simulation(const ShearBox<Dim, Real>& box, Configuration<Dim, Real> start,
                                  const ContactRules<Real>& rules,
                                  const Surroundings<Dim, Real>& surroundings)
    : frame_(box, surroundings.common_acceleration()),
      spheres_(box, std::move(start), surroundings.acceleration - frame_.acceleration()),
      rules_(rules),
      surroundings_(surroundings),
      calendar_(spheres_.count()),
      meetings_(static_cast<std::size_t>(spheres_.count())),
      span_(box.clock_unit()),
      rewind_bound_(box, surroundings.acceleration, spheres_.largest_diameter()) {
  assert(!surroundings.walls ? !box.closed_axis() : box.is_closed(surroundings.walls->axis));
  assert(surroundings.all_fall ==
         (grains().immobile.empty() || surroundings.acceleration == Vector{}));
  assert(!rules.table || grains().kind_count() <= rules.table->kinds());
  make_law();
  make_walls();
  for (std::int32_t i = 0; i < spheres(); ++i) predict(i);
}

template <int Dim, class Real>
std::optional<Collision<Dim, Real>> Simulation<Dim, Real>::collision_until(double until) {
  waiting_ = false;
  Instant<Real> limit = instant(until);
  // Without collisions the caller is asked again about once per sphere that is settled.
  for (std::int32_t patience = 2 * spheres() + 1024; patience > 0 && !stopped_before_; --patience) {
    const std::int32_t i = calendar_.earliest();
    if (spheres() > most_spheres_in_cache) fetch_ahead();
    // Sliding layers do not rest, nor does what is too slow for the exponents of its squares.
    if (i == Calendar<Real>::kNone) at_rest_ = !box().is_sheared() && move_as_one();
    if (at_rest_) return std::nullopt;
    const Real next =
        i == Calendar<Real>::kNone ? std::numeric_limits<Real>::infinity() : calendar_.time(i);
    waiting_ = is_past(limit, next);
    if (waiting_) return std::nullopt;
    if (next >= span_) {
      rebase(next, limit);
      limit = instant(until);
      continue;
    }
    const Meeting<Real>& meeting = meetings(i).first();
    if (next < meeting.time) {
      settle(i);
    } else if (is_stale(meeting)) {
      go_stale(i);
    } else if (meeting.is_overlap() && rules_.overlap == OverlapRule::stop && has_begun(now_)) {
      const std::int32_t j = meeting.partner();
      const auto [a, b] = std::minmax(i, j);
      stopped_before_ = {a, b,
                         gap_at_last_change(a, b, neighbour(a, b, meeting.time), meeting.time)};
    } else {
      return next_with(i);
    }
  }
  return std::nullopt;
}

/// Whether an event at the clock's remainder `next` comes after `limit`.
///
/// Without shear the clock leaps over whole units to the next event, never just to the limit: where
/// it is set back in two steps instead of one, rounding leaves a trace.
template <int Dim, class Real>
bool Simulation<Dim, Real>::is_past(const Instant<Real>& limit, const Real& next) const {
  using std::floor;
  const double left = limit.units - now_.units;
  if (left <= 0) return left < 0 || next > limit.remainder;
  if (next < span_ || box().is_sheared()) return false;
  return floor(static_cast<Real>(next / span_)) * Real(stride_) > static_cast<Real>(left);
}

template <int Dim, class Real>
bool Simulation<Dim, Real>::has_reached(double time) const {
  const Instant<Real> wanted = instant(time);
  return now_.units > wanted.units ||
         (now_.units == wanted.units && now_.remainder >= wanted.remainder);
}

/// Does the collision that sphere i has pending.
template <int Dim, class Real>
Collision<Dim, Real> Simulation<Dim, Real>::next_with(std::int32_t i) {
  const Meeting<Real>& meeting = meetings(i).first();
  Collision<Dim, Real> collision;
  collision.overlapping = meeting.is_overlap();
  collision.i = std::min(i, meeting.partner());
  collision.j = std::max(i, meeting.partner());
  const Real when = meeting.time;
  const Neighbour neighbour = this->neighbour(collision.i, collision.j, when);
  collision.gap_before = gap_at_last_change(collision.i, collision.j, neighbour, when);

  now_.remainder = when;
  // Not copies of now_: to read 16 bytes of which 8 have just been written takes a long wait.
  collision.time = {now_.units, when};
  collision.flight = elapsed(last_collision_, {now_.units, when}, box().clock_unit());
  collision.number = ++collisions_;
  last_collision_ = {now_.units, when};
  last_change_ = {now_.units, when};
  idle_events_ = 0;
  if (const auto wall = this->wall(collision.j)) {
    bounce(collision, *wall);
  } else {
    meet(collision, neighbour);
  }
  note_change(collision);
  // A processor begins to look for the second one while it still waits for roots of the first.
  const bool is_pair = !wall(collision.j);
  look_ahead(collision.i);
  if (is_pair) look_ahead(collision.j);
  schedule(collision.i);
  if (is_pair) schedule(collision.j);
  return collision;
}

/// The collision of two spheres.
template <int Dim, class Real>
void Simulation<Dim, Real>::meet(Collision<Dim, Real>& collision, Neighbour neighbour) {
  auto& a = spheres_[collision.i];
  auto& b = spheres_[collision.j];
  spheres_.advance(a, now_.remainder);
  spheres_.advance(b, now_.remainder);
  ++a.collisions;
  ++b.collisions;
  const auto motion = spheres_.motion_as_stored(collision.i, neighbour, now_.remainder);
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
  auto& a = spheres_[collision.i];
  auto& b = spheres_[collision.j];
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
  auto& spin = spheres_.spins()[static_cast<std::size_t>(sphere)];
  const auto before = spin;
  spin += change_of_spin(collision, sphere);
  return !(spin == before);
}

/// Tells what bounds the steps back of the clock how velocities have changed.
template <int Dim, class Real>
void Simulation<Dim, Real>::note_change(const Collision<Dim, Real>& collision) {
  if (!law_) return rewind_bound_.note_change(collision.change, now_.remainder);
  for (const std::int32_t sphere : {collision.i, collision.j}) {
    if (wall(sphere)) continue;
    rewind_bound_.note_change(collision.change * grains().inverse_mass(sphere), now_.remainder);
  }
}

/// How sphere i sees the sphere j that it meets at `when`; of no meaning where j is a wall.
template <int Dim, class Real>
Neighbour Simulation<Dim, Real>::neighbour(std::int32_t i, std::int32_t j, const Real& when) const {
  return wall(j) ? Neighbour() : spheres_.neighbour(i, j, when);
}

/// The distance that two spheres, or a sphere and a wall, have to close from the last change of a
/// velocity to their contact, diameters. Where one falls off the other and back it is that at the
/// last change or, if that is wider, half-way.
///
/// \param neighbour  the image that will be in contact
/// \param contact    when that will be
template <int Dim, class Real>
Real Simulation<Dim, Real>::gap_at_last_change(std::int32_t i, std::int32_t j, Neighbour neighbour,
                                               const Real& contact) const {
  const Real when =
      last_change_.remainder +
      (static_cast<Real>(last_change_.units) - static_cast<Real>(now_.units)) * box().clock_unit();
  if (const auto wall = this->wall(j)) return widest_wall_gap(i, *wall, when, contact);
  const Real sigma = spheres_.sigma(i, j);
  const Real then = gap(spheres_.motion(i, neighbour, when).dr, sigma);
  if (!spheres_.fall_apart(i, j)) return then;
  const Real half_way = when + (contact - when) / 2;
  return std::max(then, gap(spheres_.motion(i, neighbour, half_way).dr, sigma));
}

/// Settles a sphere again; one that is late by rounding at once.
template <int Dim, class Real>
void Simulation<Dim, Real>::settle(std::int32_t i) {
  ++settlings_;
  now_.remainder = std::max(now_.remainder, calendar_.time(i));
  ++idle_events_;
  if (is_idle() && spheres_.is_far_out(i, now_.remainder)) {
    come_home();
    leap();  // nobody has come near: at once, if nobody is near now
  } else {
    predict_new(i, spheres_.settle(i, now_.remainder, meetings(i).first().time));
  }
  if (spheres_.is_crowded()) [[unlikely]] {
    spheres_.settle_in_crowd(now_.remainder);
    for (std::int32_t k = 0; k < spheres(); ++k) predict(k);
  }
  if (is_idle()) look_around();
}

template <int Dim, class Real>
Configuration<Dim, Real> Simulation<Dim, Real>::configuration() const {
  Configuration<Dim, Real> state = spheres_.configuration(now_.units, now_.remainder);
  if (!frame_.moves()) return state;
  const auto frame = frame_.place(now_, state.offset);
  const Vector velocity = frame_.velocity(now_);
  for (std::size_t i = 0; i < state.positions.size(); ++i) {
    typename MovingFrame<Dim, Real>::Place place{state.positions[i] + frame.in_box,
                                                 state.boxes[i] + frame.boxes};
    frame_.wrap(place, state.offset);
    state.positions[i] = place.in_box;
    state.boxes[i] = place.boxes;
  }
  for (Vector& own : state.velocities) own += velocity;
  return state;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class Simulation<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
