// Bounces off walls, which may oscillate or be thermal.

#include <algorithm>
#include <cmath>

#include "model/instantiate.hpp"
#include "verify/replay.hpp"

namespace zenosphere::verify {

template <int Dim>
Meeting<Dim> Replay<Dim>::wall_meeting(const CollisionRow& row, int wall, Number time) {
  if (wall != 0) return motion_.wall_meeting(body(row.i), wall, time, {});
  return motion_.wall_meeting(body(row.i), wall, time,
                              {lower_wall_.height(time), lower_wall_.speed(time),
                               lower_wall_.peak_speed(), lower_wall_.peak_acceleration()});
}

template <int Dim>
void Replay<Dim>::bounce(const CollisionRow& row, int wall, const Meeting<Dim>& meeting,
                         Findings& findings) {
  const Case::Walls& walls = values_.walls;
  const int axis = *motion_.closed_axis();
  Body<Dim>& one = body(row.i);
  one = motion_.moved(one, row.time);
  one.position[axis] = wall == 0 ? one.radius : motion_.sides()[axis] - one.radius;
  const bool oscillates = wall == 0 && lower_wall_.oscillates();
  if (oscillates) {
    one.position[axis] += lower_wall_.height(row.time);
    one.position_error += lower_wall_.peak_speed() * motion_.clock_error(row.time);
    one.velocity_error += lower_wall_.peak_acceleration() * motion_.clock_error(row.time);
  }
  const bool rests = (row.flags & collision_flag::resting) != 0;
  if (!(row.normal_speed > 0) && !rests) return;
  const Precision precision = values_.collision.precision;
  const Number outward = wall == 0 ? -1 : 1;
  const Number tangential = in_precision(walls.tangential_restitution, precision);
  const Vector before = one.velocity;
  const Number parting = rests ? lower_wall_.resting_speed(row.time, -motion_.acceleration()[axis])
                               : law_.restitution(row) * row.normal_speed;
  one.velocity[axis] = -outward * parting;
  if (oscillates) one.velocity[axis] += lower_wall_.speed(row.time);
  for (int along = 0; along < Dim && !law_.is_rough(); ++along) {
    if (along == axis) continue;
    const double wall_speed = along != 0 ? 0.0 : wall == 0 ? walls.lower_speed : walls.upper_speed;
    one.velocity[along] = (1 + tangential) * wall_speed - tangential * one.velocity[along];
  }
  if (law_.is_rough()) {
    Meeting<Dim> contact = meeting;
    contact.velocity = before * Number(-1);  // along the normal of no meaning
    contact.velocity[0] += wall == 0 ? walls.lower_speed : walls.upper_speed;
    const Number mass = 1 / law_.inverse_mass(row.i);
    const Number impulse = mass * (row.normal_speed + parting);
    const Number mu =
        walls.friction ? walls.friction->coefficient : ContactConstants<double>::unbounded();
    Number error = impulse * 8 * double_rounding;
    const Vector rubbed = rub(row, contact, impulse, {1, tangential, mu}, error, findings);
    one.velocity -= rubbed * (1 / mass);
    one.velocity_error += error / mass;
  }
  motion_.add_momentum(one.velocity - before);
  const Number change = 2 * (length(before) + length(one.velocity));
  one.position_error += change * motion_.clock_error(row.time);
  one.velocity_error +=
      4 * double_rounding * change + length(motion_.acceleration()) * motion_.clock_error(row.time);
}

/// \param after  the velocity that the wall gives; nothing where that is not known
template <int Dim>
void Replay<Dim>::bounce_hot(const CollisionRow& row, const std::optional<Vector>& after) {
  if (!after) return lose(row);
  const int axis = *motion_.closed_axis();
  const int side = *wall(row.j);
  Body<Dim>& one = body(row.i);
  one = motion_.moved(one, row.time);
  one.position[axis] = side == 0 ? one.radius : motion_.sides()[axis] - one.radius;
  motion_.add_momentum(*after - one.velocity);
  const Number change = 2 * (length(one.velocity) + length(*after));
  one.velocity = *after;
  one.position_error += change * motion_.clock_error(row.time);
  one.velocity_error = 32 * double_rounding * change;  // the engine's logarithm, sums and roots
}

/// The wider one of the gaps at the last change and half-way from there to the contact.
template <int Dim>
typename Replay<Dim>::Gap Replay<Dim>::gap_to_oscillating_wall(const CollisionRow& row) {
  const Number half_way = (last_change_ + row.time) / 2;
  const Meeting<Dim> then = wall_meeting(row, 0, last_change_);
  const Meeting<Dim> later = wall_meeting(row, 0, half_way);
  const Meeting<Dim>& wider = later.gap > then.gap ? later : then;
  return {wider.gap, wider.error + 2 * wider.speed * motion_.clock_error(row.time) +
                         4 * double_rounding * std::abs(wider.gap)};
}

#define ZENOSPHERE_INSTANTIATE(Dim)                                                            \
  template Meeting<Dim> Replay<Dim>::wall_meeting(const CollisionRow&, int, Number);           \
  template void Replay<Dim>::bounce(const CollisionRow&, int, const Meeting<Dim>&, Findings&); \
  template void Replay<Dim>::bounce_hot(const CollisionRow&, const std::optional<Vector>&);    \
  template typename Replay<Dim>::Gap Replay<Dim>::gap_to_oscillating_wall(const CollisionRow&);
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere::verify
