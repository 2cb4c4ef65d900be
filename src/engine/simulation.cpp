#include "engine/simulation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim, class Real>
Simulation<Dim, Real>::Simulation(const ShearBox<Dim, Real>& box,
                                  const Configuration<Dim, Real>& start,
                                  const ContactRules<Real>& rules,
                                  const Surroundings<Dim, Real>& surroundings)
    : spheres_(box, start, surroundings.acceleration),
      rules_(rules),
      surroundings_(surroundings),
      calendar_(spheres_.count()),
      pending_(start.positions.size()) {
  assert(!surroundings.walls ? !box.closed_axis() : box.is_closed(surroundings.walls->axis));
  apply_models();
  for (std::int32_t i = 0; i < spheres(); ++i) predict(i);
}

template <int Dim, class Real>
std::optional<Collision<Dim, Real>> Simulation<Dim, Real>::collision_until(double until) {
  waiting_ = false;
  const Instant<Real> limit = instant_at(until, box().clock_unit());
  // Without collisions the caller is asked again about once per sphere and crossing.
  for (std::int32_t patience = 2 * spheres() + 1024; patience > 0 && !stopped_before_; --patience) {
    const std::int32_t i = calendar_.earliest();
    at_rest_ = i == Calendar<Real>::kNone && !box().is_sheared();  // sliding layers do not rest
    if (at_rest_) return std::nullopt;
    const Real next =
        i == Calendar<Real>::kNone ? std::numeric_limits<Real>::infinity() : calendar_.time(i);
    waiting_ = is_past(limit, next);
    if (waiting_) return std::nullopt;
    if (next >= box().clock_unit()) {
      rebase(next, limit);
      continue;
    }
    const Pending& event = pending(i);
    if (event.crossing < event.contact) {
      cross(i);
    } else if (is_stale(event)) {
      now_.remainder = std::max(now_.remainder, next);
      ++stale_events_;
      predict(i);
    } else if (event.overlapping && rules_.overlap == OverlapRule::stop) {
      const auto [a, b] = std::minmax(i, event.partner);
      stopped_before_ = {a, b, gap_at_last_change(a, b)};
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
  const std::int64_t left = limit.units - now_.units;
  if (left <= 0) return left < 0 || next > limit.remainder;
  if (next < box().clock_unit() || box().is_sheared()) return false;
  return floor(static_cast<Real>(next / box().clock_unit())) > static_cast<Real>(left);
}

template <int Dim, class Real>
bool Simulation<Dim, Real>::has_reached(double time) const {
  const Instant<Real> wanted = instant_at(time, box().clock_unit());
  return now_.units > wanted.units ||
         (now_.units == wanted.units && now_.remainder >= wanted.remainder);
}

template <int Dim, class Real>
bool Simulation<Dim, Real>::is_stale(const Pending& event) const {
  if (wall(event.partner)) return false;
  return spheres_[event.partner].collisions != event.partner_collisions;
}

template <int Dim, class Real>
void Simulation<Dim, Real>::predict(std::int32_t i) {
  spheres_.advance(spheres_[i], now_.remainder);
  pending(i).contact = std::numeric_limits<Real>::infinity();
  predict_crossing(i);
  predict_contacts(i, spheres_.cells().neighbourhood());
  if (surroundings_.walls) predict_walls(i);
  schedule(i);
}

template <int Dim, class Real>
void Simulation<Dim, Real>::predict_crossing(std::int32_t i) {
  const auto crossing = spheres_.next_crossing(spheres_[i]);
  Pending& event = pending(i);
  event.crossing = crossing.time;
  event.axis = static_cast<std::int8_t>(crossing.axis);
  event.direction = static_cast<std::int8_t>(crossing.direction);
}

template <int Dim, class Real>
void Simulation<Dim, Real>::predict_contacts(std::int32_t i,
                                             const typename SlidingCells<Dim>::Stencil& stencil) {
  Pending& event = pending(i);
  const auto visit = [&](std::int32_t j, const RelativeMotion<Dim, Real>& motion) {
    if (const auto contact = zenosphere::contact(motion)) consider(event, j, *contact);
  };
  spheres_.for_each_neighbour(i, stencil, now_.remainder, visit);
}

template <int Dim, class Real>
void Simulation<Dim, Real>::predict_walls(std::int32_t i) {
  const int axis = surroundings_.walls->axis;
  for (const int wall : {0, 1}) {
    const Real outward = wall == 0 ? -1 : 1;
    const Real gap = wall_gap(i, wall, now_.remainder);
    const Real rate = -outward * spheres_[i].velocity[axis];
    const auto time = closing_time<Real>(gap, rate, -outward * surroundings_.acceleration[axis]);
    if (time) consider(pending(i), spheres() + wall, {*time, gap < 0 && *time <= 0, rate});
  }
}

/// Keeps the contact with j if it comes before the one that is pending. Walls let nobody pass.
template <int Dim, class Real>
void Simulation<Dim, Real>::consider(Pending& event, std::int32_t j, Contact<Real> contact) {
  if (contact.overlapping && rules_.overlap != OverlapRule::rewind) {
    contact.time = 0;
    const bool may_pass = rules_.overlap == OverlapRule::guarded && !wall(j);
    if (may_pass && !(contact.approach < -rules_.guard)) {
      ++overlaps_ignored_;
      return;
    }
  }
  const Real time = now_.remainder + contact.time;
  if (!(time < event.contact)) return;
  event.contact = time;
  event.partner = j;
  event.partner_collisions = wall(j) ? 0 : spheres_[j].collisions;
  event.overlapping = contact.overlapping;
}

template <int Dim, class Real>
void Simulation<Dim, Real>::schedule(std::int32_t i) {
  const Pending& event = pending(i);
  calendar_.schedule(i, std::min(event.contact, event.crossing));
}

/// Does the collision that sphere i has pending.
template <int Dim, class Real>
Collision<Dim, Real> Simulation<Dim, Real>::next_with(std::int32_t i) {
  const Pending& event = pending(i);
  Collision<Dim, Real> collision;
  collision.overlapping = event.overlapping;
  collision.i = std::min(i, event.partner);
  collision.j = std::max(i, event.partner);
  collision.gap_before = gap_at_last_change(collision.i, collision.j);

  now_.remainder = event.contact;
  collision.time = now_;
  collision.flight = elapsed(last_collision_, now_, box().clock_unit());
  collision.number = ++collisions_;
  last_collision_ = last_change_ = now_;
  if (const auto wall = this->wall(collision.j)) {
    bounce(collision, *wall);
  } else {
    meet(collision);
  }
  predict(collision.i);
  if (!wall(collision.j)) predict(collision.j);
  return collision;
}

/// The collision of two spheres.
template <int Dim, class Real>
void Simulation<Dim, Real>::meet(Collision<Dim, Real>& collision) {
  auto& a = spheres_[collision.i];
  auto& b = spheres_[collision.j];
  spheres_.advance(a, now_.remainder);
  spheres_.advance(b, now_.remainder);
  const auto motion = spheres_.motion(collision.i, collision.j, now_.remainder);
  collision.impact = impact(motion, rules_.restitution);
  collision.change = collision.impact.normal * -collision.impact.impulse;
  if (contact_physics_) contact_physics_->amend(collision, motion.dv);
  const Vector velocity_a = a.velocity;
  const Vector velocity_b = b.velocity;
  a.velocity += collision.change;
  b.velocity -= collision.change;
  collision.absorbed = a.velocity == velocity_a && b.velocity == velocity_b;
  ++a.collisions;
  ++b.collisions;
}

/// The collision of a sphere with a wall. Its place is known exactly then, half a diameter from
/// the wall, and so is its speed after a fall: neither is left to rounding.
template <int Dim, class Real>
void Simulation<Dim, Real>::bounce(Collision<Dim, Real>& collision, int wall) {
  Walls<Real> walls = *surroundings_.walls;
  if (contact_physics_) contact_physics_->amend(collision, walls);
  auto& sphere = spheres_[collision.i];
  const Real outward = wall == 0 ? -1 : 1;
  const Real acceleration = -outward * surroundings_.acceleration[walls.axis];
  Real& velocity = sphere.velocity[walls.axis];
  const Real speed = closing_speed<Real>(wall_gap(collision.i, wall, sphere.time),
                                         -outward * velocity, acceleration);
  spheres_.advance(sphere, now_.remainder);
  sphere.position[walls.axis] = wall == 0 ? Real(0.5) : Real(box().sides()[walls.axis] - Real(0.5));
  if (acceleration != 0) velocity = outward * speed;
  const auto [impact, change] = wall_impact(walls, wall, sphere.velocity);
  collision.impact = impact;
  collision.change = change;
  const Vector before = sphere.velocity;
  sphere.velocity += collision.change;
  collision.absorbed = sphere.velocity == before;
  ++sphere.collisions;
}

/// Surface distance to a wall, diameters.
template <int Dim, class Real>
Real Simulation<Dim, Real>::wall_gap(std::int32_t i, int wall, const Real& when) const {
  const int axis = surroundings_.walls->axis;
  const Real place = spheres_.position_at(spheres_[i], when)[axis];
  return wall == 0 ? place - Real(0.5) : (box().sides()[axis] - Real(0.5)) - place;
}

template <int Dim, class Real>
Real Simulation<Dim, Real>::gap_at_last_change(std::int32_t i, std::int32_t j) const {
  const Real when = last_change_.remainder +
                    static_cast<Real>(last_change_.units - now_.units) * box().clock_unit();
  if (const auto wall = this->wall(j)) return wall_gap(i, *wall, when);
  return gap(spheres_.motion(i, j, when).dr);
}

/// Moves a sphere to the adjacent cell; one that is late by rounding moves at once.
template <int Dim, class Real>
void Simulation<Dim, Real>::cross(std::int32_t i) {
  ++cell_crossings_;
  const Pending& event = pending(i);
  now_.remainder = std::max(now_.remainder, event.crossing);
  spheres_.advance(spheres_[i], now_.remainder);
  const int axis = event.axis;
  const int direction = event.direction;
  spheres_.cross(i, {event.crossing, axis, direction}, now_.remainder);
  predict_crossing(i);
  predict_contacts(i, spheres_.cells().new_after_crossing(axis, direction));
  schedule(i);
}

/// Sets the clock and all times back by whole units; the layers slide by as many cells.
template <int Dim, class Real>
void Simulation<Dim, Real>::rebase(const Real& next_event, const Instant<Real>& limit) {
  using std::floor;
  const std::int64_t left = limit.units - now_.units;
  std::int64_t units = 1;
  if (!box().is_sheared()) {  // nothing happens until the next event: go there at once
    const Real whole = floor(static_cast<Real>(next_event / box().clock_unit()));
    units = whole < static_cast<Real>(left) ? static_cast<std::int64_t>(whole) : left;
  }
  const Real span = static_cast<Real>(units) * box().clock_unit();
  now_.units += units;
  now_.remainder = std::max(Real(0), Real(now_.remainder - span));
  spheres_.set_back(span);
  for (Pending& event : pending_) {
    event.contact -= span;
    event.crossing -= span;
  }
  calendar_.set_back(span);
  if (!box().is_sheared()) return;
  for (std::int32_t i = 0; i < spheres(); ++i) {
    predict_contacts(i, spheres_.cells().new_after_slide());
    schedule(i);
  }
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class Simulation<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
