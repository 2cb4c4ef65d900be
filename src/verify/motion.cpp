#include "verify/motion.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "case/case_box.hpp"
#include "case/case_grains.hpp"
#include "model/instantiate.hpp"
#include "model/real.hpp"

namespace zenosphere::verify {
namespace {

/// Rounding of the engine's arithmetic, or of this where the engine's is finer.
long double rounding_of(Precision precision) {
  return precision == Precision::double_precision ? double_rounding : 0x1p-62L;
}

}  // namespace

long double in_precision(double value, Precision precision) {
  if (precision == Precision::double_precision) return value;
  return from_decimal<long double>(value);
}

template <int Dim>
Motion<Dim>::Motion(const Case& values, std::int64_t spheres, Number largest)
    : some_are_held_(has_immobile_species(values)),
      closed_(zenosphere::closed_axis(values)),
      shear_rate_(in_precision(values.drive.shear_rate, values.collision.precision)),
      rounding_(rounding_of(values.collision.precision)),
      spheres_(static_cast<Number>(spheres)) {
  const std::vector<double> sides = box_sides(values);
  Number volume = 1;
  for (int axis = 0; axis < Dim; ++axis) {
    const auto at = static_cast<std::size_t>(axis);
    sides_[axis] = sides[at];
    longest_ = std::max(longest_, sides_[axis]);
    volume *= sides_[axis];
    if (!values.gravity.acceleration.empty()) {
      acceleration_[axis] =
          in_precision(values.gravity.acceleration[at], values.collision.precision);
    }
  }
  // A snapshot puts a layer where it is by its number times the slide, which is below two boxes.
  const Number layers = Dim > 1 && shear_rate_ > 0 ? sides_[Dim > 1 ? 1 : 0] : Number(0);
  storage_error_ = 2 * double_rounding * longest_ + rounding_ * sides_[0] * (4 + 2 * layers);
  // Contact is predicted from a cell or two away; the square of the distance is rounded.
  const Number spacing = std::pow(volume / static_cast<Number>(spheres), 1.0L / Dim);
  const Number reach = std::min(longest_, 4 * spacing + 4 * largest);
  event_error_ = 4 * rounding_ * (longest_ + reach * reach);
}

template <int Dim>
void Motion<Dim>::start(double time, double offset, const Vector& momentum) {
  start_time_ = time;
  start_offset_ = offset;
  momentum_ = {};
  add_momentum(momentum);
}

template <int Dim>
void Motion<Dim>::add_momentum(const Vector& change) {
  momentum_ += change;
  Vector mean;
  for (int axis = 0; axis < Dim; ++axis) {
    if (is_free(axis)) mean[axis] = momentum_[axis] / spheres_;
  }
  drift_ = std::max(drift_, length(mean));
}

/// A bound on how fast the frame moves in which the engine follows the spheres: it drifts and falls
/// with them all, so that one that rests in the laboratory is rounded as one that flies.
template <int Dim>
typename Motion<Dim>::Number Motion<Dim>::frame_speed(Number time) const {
  Vector fall;
  for (int axis = 0; axis < Dim; ++axis) {
    if (frame_falls(axis)) fall[axis] = acceleration_[axis] * (time - start_time_);
  }
  return drift_ + length(fall);
}

template <int Dim>
Body<Dim> Motion<Dim>::stored(const Vector& position, const Vector& velocity, double time,
                              Number radius) const {
  const Number speed = length(velocity) + shear_rate_ * longest_ + frame_speed(time);
  return {position, velocity, time, storage_error_, 4 * double_rounding * speed, radius};
}

template <int Dim>
typename Motion<Dim>::Number Motion<Dim>::clock_error(Number time) const {
  const Number unit = shear_rate_ > 0 ? 4 / shear_rate_ : Number(1);
  return double_rounding * (time + start_time_) + 16 * rounding_ * unit;
}

template <int Dim>
Body<Dim> Motion<Dim>::moved(Body<Dim> body, Number time) const {
  const Number flight = time - body.time;
  const Vector pull = body.is_held ? Vector{} : acceleration_;
  body.position += body.velocity * flight + pull * (flight * flight / 2);
  const Number speed = length(body.velocity) + frame_speed(time);
  body.velocity += pull * flight;
  body.time = time;
  if (body.position_error == unknown) return body;
  // The engine rounds at the end of a flight and at each cell that it passes.
  const Number roundings = 1 + Dim * speed * std::abs(flight);
  body.position_error +=
      std::abs(flight) * body.velocity_error + roundings * 2 * rounding_ * longest_;
  body.velocity_error += roundings * 2 * rounding_ * (speed + length(pull) * flight);
  return body;
}

template <int Dim>
typename Motion<Dim>::Vector Motion<Dim>::boxes_to_nearest(Vector between, Number time) const {
  Vector boxes;
  for (int axis = Dim - 1; axis >= 0; --axis) {  // the gradient before the flow, which it displaces
    if (closed_ == axis) continue;
    boxes[axis] = std::round(between[axis] / sides_[axis]);
    if (axis == 1) between[0] -= boxes[axis] * image_offset(time);
  }
  return boxes;
}

template <int Dim>
typename Motion<Dim>::Vector Motion<Dim>::without(const Vector& boxes, Vector between,
                                                  Number time) const {
  for (int axis = 0; axis < Dim; ++axis) between[axis] -= boxes[axis] * sides_[axis];
  if constexpr (Dim > 1) between[0] -= boxes[1] * image_offset(time);
  return between;
}

template <int Dim>
typename Motion<Dim>::Number Motion<Dim>::image_offset(Number time) const {
  if constexpr (Dim == 1) return 0;
  return start_offset_ + shear_rate_ * sides_[Dim > 1 ? 1 : 0] * (time - start_time_);
}

template <int Dim>
Meeting<Dim> Motion<Dim>::meeting(const Body<Dim>& first, const Body<Dim>& second, Number time,
                                  Number contact) const {
  const Vector boxes =
      boxes_to_nearest(moved(second, contact).position - moved(first, contact).position, contact);
  const Body<Dim> a = moved(first, time);
  const Body<Dim> b = moved(second, time);
  const Vector between = without(boxes, b.position - a.position, time);
  Vector velocity = b.velocity - a.velocity;
  velocity[0] -= image_velocity(Dim > 1 ? boxes[Dim > 1 ? 1 : 0] : Number(0));
  const Number distance = length(between);
  Meeting<Dim> meeting;
  meeting.normal = between * (1 / distance);
  meeting.velocity = velocity;
  meeting.sigma = a.radius + b.radius;
  meeting.gap = (distance - meeting.sigma) / meeting.sigma;
  meeting.closing = -dot(meeting.normal, velocity);
  meeting.speed = length(velocity);
  meeting.error = a.position_error + b.position_error + event_error_;
  meeting.normal_error = meeting.error + meeting.speed * clock_error(time);
  meeting.closing_error = a.velocity_error + b.velocity_error +
                          meeting.speed * meeting.normal_error +
                          8 * double_rounding * meeting.speed;
  return meeting;
}

template <int Dim>
Meeting<Dim> Motion<Dim>::wall_meeting(const Body<Dim>& body, int wall, Number time,
                                       const WallState& state) const {
  const Body<Dim> a = moved(body, time);
  const int axis = *closed_;
  const Number outward = wall == 0 ? -1 : 1;
  Meeting<Dim> meeting;
  meeting.normal[axis] = outward;
  meeting.velocity = a.velocity * Number(-1);
  meeting.velocity[axis] += state.speed;
  meeting.gap = (wall == 0 ? a.position[axis] : sides_[axis] - a.position[axis]) - a.radius;
  meeting.gap -= state.place;
  meeting.closing = outward * (a.velocity[axis] - state.speed);
  meeting.speed = length(a.velocity) + state.peak_speed;
  meeting.error = a.position_error + event_error_;
  meeting.normal_error = 0;
  // The engine takes the speed from the height of the fall, this one from its rounded duration.
  meeting.closing_error =
      a.velocity_error + 8 * double_rounding * meeting.speed +
      2 * (std::abs(acceleration_[axis]) + state.peak_acceleration) * clock_error(time);
  return meeting;
}

template <int Dim>
typename Motion<Dim>::Number Motion<Dim>::image_velocity(Number boxes_up) const {
  if constexpr (Dim == 1) return 0;
  return boxes_up * shear_rate_ * sides_[Dim > 1 ? 1 : 0];
}

template <int Dim>
typename Motion<Dim>::Number Motion<Dim>::shortest_side() const {
  return *std::min_element(sides_.components.begin(), sides_.components.end());
}

#define ZENOSPHERE_INSTANTIATE(Dim) template class Motion<Dim>;
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere::verify
