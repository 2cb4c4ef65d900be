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
                                  const ContactRules<Real>& rules)
    : box_(box),
      rules_(rules),
      cells_(box.cells(), box.is_sheared(), static_cast<std::int32_t>(start.positions.size())),
      calendar_(static_cast<std::int32_t>(start.positions.size())),
      spheres_(start.positions.size()),
      pending_(start.positions.size()) {
  assert(start.positions.size() == start.velocities.size());
  place(start);
  for (std::int32_t i = 0; i < spheres(); ++i) predict(i);
}

template <int Dim, class Real>
void Simulation<Dim, Real>::place(const Configuration<Dim, Real>& start) {
  using std::floor;
  const Vector width = box_.cell_width();
  for (std::int32_t i = 0; i < spheres(); ++i) {
    Sphere& sphere = this->sphere(i);
    const Vector& position = start.positions[static_cast<std::size_t>(i)];
    Steps<Dim> coordinates{};
    for (int axis = 0; axis < Dim; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const int cell = static_cast<int>(floor(static_cast<Real>(position[axis] / width[axis])));
      coordinates[a] = std::clamp(cell, 0, box_.cells()[a] - 1);
    }
    sphere.position = position;
    sphere.cell = cells_.index(coordinates);
    cells_.insert(i, sphere.cell);
    sphere.velocity = start.velocities[static_cast<std::size_t>(i)];
    sphere.velocity[0] += profile_in_layer(sphere);
  }
}

template <int Dim, class Real>
std::optional<Collision<Dim, Real>> Simulation<Dim, Real>::next_collision(double until) {
  const Instant<Real> limit = instant(until);
  // Without collisions the caller is asked again about once per sphere and crossing.
  for (std::int32_t patience = 2 * spheres() + 1024; patience > 0 && !stopped_before_; --patience) {
    const std::int32_t i = calendar_.earliest();
    if (i == Calendar<Real>::kNone) {
      at_rest_ = true;
      return std::nullopt;
    }
    const Real next = calendar_.time(i);
    if (is_past(limit, next)) {
      if (now_.units == limit.units) now_.remainder = std::max(now_.remainder, limit.remainder);
      return std::nullopt;
    }
    if (next >= box_.clock_unit()) {
      rebase(next, limit);
      continue;
    }
    const Pending& pending = pending_[static_cast<std::size_t>(i)];
    if (pending.crossing < pending.contact) {
      cross(i);
    } else if (sphere(pending.partner).collisions != pending.partner_collisions) {
      now_.remainder = std::max(now_.remainder, next);
      ++stale_events_;
      predict(i);
    } else if (pending.overlapping && rules_.overlap == OverlapRule::stop) {
      const auto [a, b] = std::minmax(i, pending.partner);
      stopped_before_ = {a, b, gap_at_last_collision(a, b)};
    } else {
      return collide(i);
    }
  }
  return std::nullopt;
}

/// Whether an event at the clock's remainder `next` comes after `limit`.
template <int Dim, class Real>
bool Simulation<Dim, Real>::is_past(const Instant<Real>& limit, const Real& next) const {
  return now_.units > limit.units || (now_.units == limit.units && next > limit.remainder);
}

template <int Dim, class Real>
bool Simulation<Dim, Real>::has_reached(double time) const {
  const Instant<Real> wanted = instant(time);
  return now_.units > wanted.units ||
         (now_.units == wanted.units && now_.remainder >= wanted.remainder);
}

template <int Dim, class Real>
Instant<Real> Simulation<Dim, Real>::instant(double time) const {
  using std::floor;
  const double largest = 9e18;  // fits std::int64_t
  const Real units = floor(static_cast<Real>(Real(time) / box_.clock_unit()));
  if (units > Real(largest)) return {static_cast<std::int64_t>(largest), 0};
  return {static_cast<std::int64_t>(units), Real(time) - units * box_.clock_unit()};
}

template <int Dim, class Real>
Vec<Dim, Real> Simulation<Dim, Real>::position_at(const Sphere& sphere, const Real& when) const {
  return sphere.position + sphere.velocity * (when - sphere.time);
}

/// Motion of j relative to i at the clock's remainder `when`, in the nearest image.
template <int Dim, class Real>
RelativeMotion<Dim, Real> Simulation<Dim, Real>::pair_motion(std::int32_t i, std::int32_t j,
                                                             const Real& when) const {
  using std::floor;
  const Sphere& a = sphere(i);
  const Sphere& b = sphere(j);
  const Vector dr = position_at(b, when) - position_at(a, when);
  const auto image = [&](const Steps<Dim>& way) {
    return box_.image(cells_.lag(a.cell, b.cell, way), cells_.layers(way), when);
  };
  Steps<Dim> steps{};
  for (int axis = Dim - 1; axis >= 0; --axis) {  // layers first: they decide about the columns
    const auto index = static_cast<std::size_t>(axis);
    steps[index] = cells_.steps_between(a.cell, b.cell, axis, cells_.layers(steps));
    // The way between the spheres may lead around the box: in one of few cells, or after a long
    // flight. Ten thousand periods bound the integers; no gap so long ago has a meaning.
    const Real distance = dr[axis] + image(steps).position[axis];
    const Real periods = floor(static_cast<Real>(distance / box_.sides()[axis] + Real(0.5)));
    steps[index] -=
        box_.cells()[index] * static_cast<int>(std::clamp(periods, Real(-10000), Real(10000)));
  }
  const auto [position, velocity] = image(steps);
  RelativeMotion<Dim, Real> motion{dr + position, b.velocity - a.velocity};
  motion.dv[0] += velocity;
  return motion;
}

template <int Dim, class Real>
void Simulation<Dim, Real>::advance(Sphere& sphere) const {
  sphere.position = position_at(sphere, now_.remainder);
  sphere.time = now_.remainder;
}

template <int Dim, class Real>
void Simulation<Dim, Real>::predict(std::int32_t i) {
  advance(sphere(i));
  pending_[static_cast<std::size_t>(i)].contact = std::numeric_limits<Real>::infinity();
  predict_crossing(i);
  predict_contacts(i, cells_.neighbourhood());
  schedule(i);
}

template <int Dim, class Real>
void Simulation<Dim, Real>::predict_crossing(std::int32_t i) {
  const Sphere& sphere = this->sphere(i);
  Pending& pending = pending_[static_cast<std::size_t>(i)];
  pending.crossing = std::numeric_limits<Real>::infinity();
  for (int axis = 0; axis < Dim; ++axis) {
    const Real& speed = sphere.velocity[axis];
    if (speed == 0) continue;
    const int upper = cells_.coordinates(sphere.cell)[static_cast<std::size_t>(axis)] + 1;
    const Real face = (speed > 0 ? upper : upper - 1) * box_.cell_width()[axis];
    const Real time = sphere.time + (face - sphere.position[axis]) / speed;
    if (time < pending.crossing) {
      pending.crossing = time;
      pending.face = static_cast<std::int8_t>(speed > 0 ? axis + 1 : -(axis + 1));
    }
  }
}

template <int Dim, class Real>
void Simulation<Dim, Real>::predict_contacts(std::int32_t i,
                                             const typename SlidingCells<Dim>::Stencil& stencil) {
  const Sphere& sphere = this->sphere(i);
  const Vector position = position_at(sphere, now_.remainder);
  Pending& pending = pending_[static_cast<std::size_t>(i)];
  for (const Steps<Dim>& steps : stencil) {
    const auto [cell, lag] = cells_.neighbour(sphere.cell, steps);
    std::int32_t j = cells_.first(cell);
    if (j == SlidingCells<Dim>::kNone) continue;
    const auto image = box_.image(lag, cells_.layers(steps), now_.remainder);
    for (; j != SlidingCells<Dim>::kNone; j = cells_.next(j)) {
      if (j == i) continue;
      const Sphere& other = this->sphere(j);
      RelativeMotion<Dim, Real> motion{
          (position_at(other, now_.remainder) - position) + image.position,
          other.velocity - sphere.velocity};
      motion.dv[0] += image.velocity;
      consider(pending, j, motion);
    }
  }
}

/// Keeps the contact with j if it comes before the one that is pending.
template <int Dim, class Real>
void Simulation<Dim, Real>::consider(Pending& pending, std::int32_t j,
                                     const RelativeMotion<Dim, Real>& motion) {
  auto contact = zenosphere::contact(motion);
  if (!contact) return;
  if (contact->overlapping && rules_.overlap != OverlapRule::rewind) {
    contact->time = 0;
    if (rules_.overlap == OverlapRule::guarded && !(contact->approach < -rules_.guard)) {
      ++overlaps_ignored_;
      return;
    }
  }
  const Real time = now_.remainder + contact->time;
  if (!(time < pending.contact)) return;
  pending.contact = time;
  pending.partner = j;
  pending.partner_collisions = sphere(j).collisions;
  pending.overlapping = contact->overlapping;
}

template <int Dim, class Real>
void Simulation<Dim, Real>::schedule(std::int32_t i) {
  const Pending& pending = pending_[static_cast<std::size_t>(i)];
  calendar_.schedule(i, std::min(pending.contact, pending.crossing));
}

template <int Dim, class Real>
Collision<Dim, Real> Simulation<Dim, Real>::collide(std::int32_t i) {
  const Pending& pending = pending_[static_cast<std::size_t>(i)];
  const std::int32_t j = pending.partner;
  Collision<Dim, Real> collision;
  collision.overlapping = pending.overlapping;
  collision.i = std::min(i, j);
  collision.j = std::max(i, j);
  collision.gap_before = gap_at_last_collision(collision.i, collision.j);

  now_.remainder = pending.contact;
  collision.time = now_;
  collision.flight = elapsed(last_collision_, now_, box_.clock_unit());
  Sphere& a = sphere(collision.i);
  Sphere& b = sphere(collision.j);
  advance(a);
  advance(b);
  collision.impact =
      impact(pair_motion(collision.i, collision.j, now_.remainder), rules_.restitution);
  const Vector velocity_a = a.velocity;
  const Vector velocity_b = b.velocity;
  a.velocity -= collision.impact.normal * collision.impact.impulse;
  b.velocity += collision.impact.normal * collision.impact.impulse;
  collision.absorbed = a.velocity == velocity_a && b.velocity == velocity_b;
  collision.number = ++collisions_;
  last_collision_ = now_;
  ++a.collisions;
  ++b.collisions;
  predict(collision.i);
  predict(collision.j);
  return collision;
}

template <int Dim, class Real>
Real Simulation<Dim, Real>::gap_at_last_collision(std::int32_t i, std::int32_t j) const {
  const Real when = last_collision_.remainder +
                    static_cast<Real>(last_collision_.units - now_.units) * box_.clock_unit();
  return gap(pair_motion(i, j, when).dr);
}

/// Moves a sphere to the adjacent cell; one that is late by rounding moves at once.
template <int Dim, class Real>
void Simulation<Dim, Real>::cross(std::int32_t i) {
  ++cell_crossings_;
  Sphere& sphere = this->sphere(i);
  const Pending& pending = pending_[static_cast<std::size_t>(i)];
  now_.remainder = std::max(now_.remainder, pending.crossing);
  advance(sphere);
  const int direction = pending.face > 0 ? 1 : -1;
  const int axis = direction * pending.face - 1;
  Steps<Dim> steps{};
  steps[static_cast<std::size_t>(axis)] = direction;
  if (axis == 1 && box_.is_sheared()) steps[0] = column_beyond(sphere, direction);
  const auto [cell, lag] = cells_.neighbour(sphere.cell, steps);
  const auto image = box_.image(lag, cells_.layers(steps), now_.remainder);
  sphere.position -= image.position;
  sphere.velocity[0] -= image.velocity;
  cells_.remove(i, sphere.cell);
  sphere.cell = cell;
  cells_.insert(i, cell);
  predict_crossing(i);
  predict_contacts(i, cells_.new_after_crossing(axis, direction));
  schedule(i);
}

/// The step along x, -1, 0 or 1, at which a sphere arrives in the layer above or below.
template <int Dim, class Real>
int Simulation<Dim, Real>::column_beyond(const Sphere& sphere, int layers) const {
  using std::floor;
  const Real& width = box_.cell_width()[0];
  const Real slide = layers * (box_.slide_speed() * now_.remainder);
  const Real from_left = sphere.position[0] - cells_.coordinates(sphere.cell)[0] * width;
  const int column = static_cast<int>(floor(static_cast<Real>((from_left - slide) / width)));
  // The slide is below one cell, so that only rounding could lead beyond two columns.
  return layers > 0 ? std::clamp(column, -1, 0) : std::clamp(column, 0, 1);
}

/// Sets the clock and all times back by whole units; the layers slide by as many cells.
template <int Dim, class Real>
void Simulation<Dim, Real>::rebase(const Real& next_event, const Instant<Real>& limit) {
  using std::floor;
  const std::int64_t left = limit.units - now_.units;
  std::int64_t units = 1;
  if (!box_.is_sheared()) {  // nothing happens until the next event: go there at once
    const Real whole = floor(static_cast<Real>(next_event / box_.clock_unit()));
    units = whole < static_cast<Real>(left) ? static_cast<std::int64_t>(whole) : left;
  }
  const Real span = static_cast<Real>(units) * box_.clock_unit();
  now_.units += units;
  now_.remainder = std::max(Real(0), Real(now_.remainder - span));
  for (Sphere& sphere : spheres_) sphere.time -= span;
  for (Pending& pending : pending_) {
    pending.contact -= span;
    pending.crossing -= span;
  }
  calendar_.set_back(span);
  if (!box_.is_sheared()) return;
  cells_.slide_by_one_cell();
  for (std::int32_t i = 0; i < spheres(); ++i) {
    predict_contacts(i, cells_.new_after_slide());
    schedule(i);
  }
}

template <int Dim, class Real>
Vec<Dim, Real> Simulation<Dim, Real>::peculiar_velocity(std::int32_t i) const {
  Vector velocity = sphere(i).velocity;
  velocity[0] -= profile_in_layer(sphere(i));
  return velocity;
}

/// The imposed velocity at the sphere's place now, in the frame of its layer.
template <int Dim, class Real>
Real Simulation<Dim, Real>::profile_in_layer(const Sphere& sphere) const {
  if constexpr (Dim == 1) {
    return 0;
  } else {
    const Real middle = (cells_.coordinates(sphere.cell)[1] + Real(0.5)) * box_.cell_width()[1];
    return box_.shear_rate() * (position_at(sphere, now_.remainder)[1] - middle);
  }
}

template <int Dim, class Real>
Real Simulation<Dim, Real>::lees_edwards_offset() const {
  if constexpr (Dim == 1) return 0;
  using std::floor;
  const Real& side = box_.sides()[0];
  const Real offset = box_.cells()[Dim > 1 ? 1 : 0] * slide();
  return offset - side * floor(static_cast<Real>(offset / side + Real(0.5)));
}

/// Displacement of a layer against the one below it, diameters, up to two whole boxes: half a
/// layer moves by half of it.
template <int Dim, class Real>
Real Simulation<Dim, Real>::slide() const {
  if (!box_.is_sheared()) return 0;
  const auto whole_cells = static_cast<int>(now_.units % (2 * box_.cells()[0]));
  return whole_cells * box_.cell_width()[0] + box_.slide_speed() * now_.remainder;
}

/// Wraps into the box. Along the gradient only rounding can lead out, and a wrap would need the
/// Lees-Edwards offset: such a place is put on the face.
template <int Dim, class Real>
void Simulation<Dim, Real>::wrap(Vector& position) const {
  using std::floor;
  for (int axis = 0; axis < Dim; ++axis) {
    const Real& side = box_.sides()[axis];
    const Real below = side * (1 - std::numeric_limits<Real>::epsilon());
    if (axis != 1) position[axis] -= side * floor(static_cast<Real>(position[axis] / side));
    position[axis] = std::clamp(position[axis], Real(0), below);
  }
}

template <int Dim, class Real>
Configuration<Dim, Real> Simulation<Dim, Real>::configuration() const {
  Configuration<Dim, Real> state;
  for (std::int32_t i = 0; i < spheres(); ++i) {
    Vector position = position_at(sphere(i), now_.remainder);
    if constexpr (Dim > 1) {
      // The frame of layer k moves with its mid-plane; the middle of the box is at rest.
      const Real layer =
          cells_.coordinates(sphere(i).cell)[1] + Real(0.5) - box_.cells()[1] / Real(2);
      position[0] += layer * slide();
    }
    wrap(position);
    state.positions.push_back(position);
    state.velocities.push_back(peculiar_velocity(i));
  }
  return state;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class Simulation<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
