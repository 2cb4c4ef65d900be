#include "verify/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "flow/overlaps.hpp"
#include "model/instantiate.hpp"

namespace zenosphere::verify {
template <int Dim>
Replay<Dim>::Replay(const Case& values, std::int64_t spheres, std::int64_t criteria_version,
                    const Grains<double>& grains)
    : values_(values),
      criteria_version_(criteria_version),
      grains_(grains),
      motion_(values, spheres, grains.largest_diameter()),
      law_(values, spheres, grains),
      bodies_(static_cast<std::size_t>(spheres)),
      kicks_(values, spheres, grains),
      lower_wall_(values),
      thermal_walls_(values, spheres, grains) {}

template <int Dim>
std::optional<int> Replay<Dim>::wall(std::int32_t j) const {
  const auto spheres = static_cast<std::int32_t>(bodies_.size());
  return j < spheres ? std::nullopt : std::optional<int>(j - spheres);
}

template <int Dim>
void Replay<Dim>::observe(const Snapshot& snapshot, Findings& findings) {
  kick_until(snapshot.time);
  if (has_start_ && done_ == snapshot.step) compare(snapshot, findings);
  start(snapshot);
}

template <int Dim>
void Replay<Dim>::start(const Snapshot& snapshot) {
  if (done_ != snapshot.step) last_.reset();
  done_ = snapshot.step;
  has_start_ = true;
  Vector momentum;
  for (std::size_t at = 0; at < snapshot.velocities.size(); ++at) {
    momentum[static_cast<int>(at % Dim)] += snapshot.velocities[at];
  }
  motion_.start(snapshot.time, Dim > 1 ? snapshot.box_edges[Dim] : 0, momentum);
  images_ = snapshot.images;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Vector position;
    Vector velocity;
    for (int axis = 0; axis < Dim; ++axis) {
      const std::size_t at = i * Dim + static_cast<std::size_t>(axis);
      position[axis] = snapshot.positions[at];
      velocity[axis] = snapshot.velocities[at];
    }
    const auto sphere = static_cast<std::int32_t>(i);
    bodies_[i] = motion_.stored(position, velocity, snapshot.time, grains_.radius(sphere));
    bodies_[i].is_held = grains_.is_immobile(sphere);
  }
  start_turning(snapshot);
}

template <int Dim>
Meeting<Dim> Replay<Dim>::meeting_at(const CollisionRow& row, Number time, Number contact) {
  if (const auto side = wall(row.j)) return wall_meeting(row, *side, time);
  return motion_.meeting(body(row.i), body(row.j), time, contact);
}

template <int Dim>
void Replay<Dim>::observe(const CollisionRow& row, Findings& findings) {
  kick_until(row.time);
  const auto after_thermal_wall = thermal_walls_.observe(row);
  if (!has_start_ || row.k != done_ + 1) {
    ++coverage_.unreached;
    last_.reset();
    return;
  }
  done_ = row.k;
  if (may_be_set_back_behind_a_kick(row)) lose_all();
  check_last_gap(row, findings);
  const Meeting<Dim> meeting = meeting_at(row, row.time, row.time);
  const bool is_in_doubt = is_beside_a_kick(row.time);
  count(is_in_doubt ? Motion<Dim>::unknown : meeting.error);
  const bool is_known = meeting.error <= most_error && !is_in_doubt;
  if (!is_known || !check(row, meeting, findings)) {
    lose(row);
  } else if (thermal_walls_.is_thermal(row)) {
    bounce_hot(row, after_thermal_wall);
  } else if (const auto side = wall(row.j)) {
    bounce(row, *side, meeting, findings);
  } else if (const auto impulse = law_.impulse(row)) {
    collide(row, meeting, *impulse, findings);
  } else {
    lose(row);
  }
  last_ = row;
  last_change_ = row.time;
}

template <int Dim>
void Replay<Dim>::count(Number error) {
  if (!(error <= most_error)) {
    ++(law_.tells_velocities() ? coverage_.beyond : coverage_.unreached);
    return;
  }
  ++coverage_.replayed;
  coverage_.within[0] += error <= 1e-9L;
  coverage_.within[1] += error <= 1e-6L;
}

/// From now on nothing is known about the spheres of a collision.
template <int Dim>
void Replay<Dim>::lose(const CollisionRow& row) {
  body(row.i).position_error = Motion<Dim>::unknown;
  if (!wall(row.j)) body(row.j).position_error = Motion<Dim>::unknown;
}

/// From now on nothing is known about any sphere.
template <int Dim>
void Replay<Dim>::lose_all() {
  for (Body<Dim>& one : bodies_) one.position_error = Motion<Dim>::unknown;
}

/// Whether the spheres touch and approach as the row says.
template <int Dim>
bool Replay<Dim>::check(const CollisionRow& row, const Meeting<Dim>& meeting, Findings& findings) {
  const std::string place =
      fmt::format("collision {} of spheres {} and {} at time {}", row.k, row.i, row.j, row.time);
  const Number bound = meeting.error + meeting.speed * motion_.clock_error(row.time);
  const bool overlapped = (row.flags & collision_flag::overlap) != 0;
  const double permitted =
      overlapped ? deepest_permitted(values_.collision.overlap, values_.collision.guard, row.time,
                                     static_cast<double>(motion_.longest_side()),
                                     grains_.largest_diameter())
                 : 0.0;
  const Number distance = meeting.gap * meeting.sigma;
  if (distance > bound || distance < -(bound + permitted)) {
    findings.add(fmt::format("{}: their gap is {:.3g} diameters there (0 within {:.2g})", place,
                             static_cast<double>(distance), static_cast<double>(bound)));
    return false;
  }
  if (!(std::abs(meeting.closing - row.normal_speed) <= meeting.closing_error)) {
    findings.add(fmt::format("{}: normal_speed = {} (they approach at {:.17g} within {:.2g})",
                             place, row.normal_speed, static_cast<double>(meeting.closing),
                             static_cast<double>(meeting.closing_error)));
    return false;
  }
  return true;
}

/// The velocities after a collision, by the logged normal speed: errors grow by the direction of
/// the normal, the rounding of that speed, and that of the restitution law in the engine (some
/// units in the last place of a number <= 1; more just above a fixed loss).
template <int Dim>
void Replay<Dim>::collide(const CollisionRow& row, const Meeting<Dim>& meeting, Number impulse,
                          Findings& findings) {
  Number growth =
      impulse * meeting.normal_error + 8 * double_rounding * impulse + law_.impulse_error(row);
  Vector change = meeting.normal * impulse;  // of the momentum of the second
  if (law_.is_rough() && impulse > 0) {
    change += rub(row, meeting, impulse, law_.constants(row), growth, findings);
  }
  for (const auto& [sphere, direction] : {std::pair{row.i, -1}, std::pair{row.j, 1}}) {
    const Number inverse_mass = law_.inverse_mass(sphere);
    Body<Dim>& one = body(sphere);
    one = motion_.moved(one, row.time);
    one.velocity += change * (direction * inverse_mass);
    one.position_error += length(change) * inverse_mass * motion_.clock_error(row.time);
    one.velocity_error += growth * inverse_mass + 2 * motion_.rounding() * length(one.velocity);
    if (!grains_.are_alike()) motion_.add_momentum(change * (direction * inverse_mass));
  }
}

template <int Dim>
void Replay<Dim>::compare(const Snapshot& snapshot, Findings& findings) {
  ++coverage_.snapshots;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(bodies_.size()); ++i) {
    compare_sphere(i, snapshot, findings);
  }
}

template <int Dim>
void Replay<Dim>::compare_sphere(std::int32_t i, const Snapshot& snapshot, Findings& findings) {
  const Body<Dim> expected = motion_.moved(body(i), snapshot.time);
  if (!(expected.position_error <= most_error)) {
    ++coverage_.lost_spheres;
    return;
  }
  ++coverage_.spheres;
  Vector between = expected.position * Number(-1);
  Vector velocity = expected.velocity * Number(-1);
  for (int axis = 0; axis < Dim; ++axis) {
    const std::size_t at = static_cast<std::size_t>(i) * Dim + static_cast<std::size_t>(axis);
    between[axis] += snapshot.positions[at];
    velocity[axis] += snapshot.velocities[at];
  }
  const Vector boxes = motion_.boxes_to_nearest(between, snapshot.time);
  const Number distance = length(motion_.without(boxes, between, snapshot.time));
  velocity[0] -= motion_.image_velocity(Dim > 1 ? boxes[Dim > 1 ? 1 : 0] : Number(0));
  const Number speed = length(expected.velocity) + motion_.shear_rate() * motion_.longest_side();
  const Number clock = 2 * motion_.clock_error(snapshot.time);
  const Number bound = expected.position_error + motion_.storage_error() + speed * clock;
  const Number velocity_bound = expected.velocity_error + 8 * double_rounding * speed +
                                motion_.shear_rate() * bound +
                                length(motion_.acceleration()) * clock;
  // A run that ends at the time of a kick may have had it.
  const bool is_kicked = kicks_.next() <= snapshot.time + static_cast<double>(clock);
  if (!(distance <= bound)) {
    findings.add(fmt::format(
        "snapshot at collision {}: sphere {} is {:.3g} diameters from where the log leads it "
        "(0 within {:.2g})",
        snapshot.step, i, static_cast<double>(distance), static_cast<double>(bound)));
  } else if (!is_kicked && !(length(velocity) <= velocity_bound)) {
    findings.add(fmt::format(
        "snapshot at collision {}: the velocity of sphere {} differs by {:.3g} from what the log "
        "leads to (0 within {:.2g})",
        snapshot.step, i, static_cast<double>(length(velocity)),
        static_cast<double>(velocity_bound)));
  } else {
    compare_image(i, snapshot, boxes, findings);
    if (!turning_.empty()) compare_spin(i, snapshot, findings);
  }
}

/// The sphere has come through as many boxes as its flights since the start of the replay have led
/// it through, and through those that it had come through before; along x also by what the offset
/// of those above is reduced.
///
/// \param boxes  from where its flights lead to where the snapshot has it
template <int Dim>
void Replay<Dim>::compare_image(std::int32_t i, const Snapshot& snapshot, const Vector& boxes,
                                Findings& findings) const {
  if (images_.empty() || snapshot.images.empty()) return;
  const std::size_t at = static_cast<std::size_t>(i) * Dim;
  Vector expected = boxes * Number(-1);
  for (int axis = 0; axis < Dim; ++axis) {
    expected[axis] += images_[at + static_cast<std::size_t>(axis)];
  }
  if constexpr (Dim > 1) {
    const Number reduced = motion_.image_offset(snapshot.time) - snapshot.box_edges[Dim];
    expected[0] += expected[1] * std::round(reduced / motion_.sides()[0]);
  }
  for (int axis = 0; axis < Dim; ++axis) {
    const std::int32_t image = snapshot.images[at + static_cast<std::size_t>(axis)];
    if (static_cast<Number>(image) == expected[axis]) continue;
    findings.add(
        fmt::format("snapshot at collision {}: sphere {} has the image {} along axis {} "
                    "(the log leads it to {})",
                    snapshot.step, i, image, axis, static_cast<double>(expected[axis])));
  }
}

#define ZENOSPHERE_INSTANTIATE(Dim) template class Replay<Dim>;
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere::verify
