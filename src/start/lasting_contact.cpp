#include "start/lasting_contact.hpp"

#include <cstdint>

#include "case/case_box.hpp"
#include "case/wall_motion.hpp"

namespace zenosphere {

namespace {

/// Whether a sphere at a wall is pressed on it at the start, and may not rest there.
bool is_pressing(const Case& values, int side) {
  const auto axis = static_cast<std::size_t>(*closed_axis(values));
  const auto& gravity = values.gravity.acceleration;
  const double pull = gravity.empty() ? 0 : gravity[axis];
  if (side == 1) return pull > 0;
  if (!values.walls.motion) return pull < 0;
  // It rests at its lowest place, and is accelerated upwards.
  return values.walls.resting_flight == 0 && pull < peak_acceleration(values.walls);
}

}  // namespace

std::optional<LastingContact> lasting_contact(const Case& values, const GivenStart& start) {
  const auto closed = closed_axis(values);
  if (!closed) return std::nullopt;
  if (values.start.granular_temperature.value_or(0) > 0) return std::nullopt;  // all have a speed
  const auto axis = static_cast<std::size_t>(*closed);
  const bool is_held_low = is_pressing(values, 0);
  const bool is_held_high = is_pressing(values, 1);
  const auto components = static_cast<std::size_t>(start.dimension);
  for (std::size_t at = axis; at < start.positions.size(); at += components) {
    const std::size_t sphere = at / components;
    if (start.grains.is_immobile(static_cast<std::int32_t>(sphere))) continue;
    if (!start.velocities.empty() && start.velocities[at] != 0) continue;
    const double radius = start.grains.radius(static_cast<std::int32_t>(sphere));
    const bool is_low = is_held_low && start.positions[at] <= radius;
    const bool is_high = is_held_high && start.positions[at] >= start.sides[axis] - radius;
    if (is_low || is_high) return LastingContact{sphere, is_low && values.walls.motion};
  }
  return std::nullopt;
}

}  // namespace zenosphere
