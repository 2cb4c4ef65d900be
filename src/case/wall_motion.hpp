#pragma once

#include <numbers>

#include "case/case.hpp"

namespace zenosphere {

/// Of the wall of a case that oscillates, diameters/time.
inline double peak_speed(const Case::Walls& walls) {
  const double turning = walls.motion == OscillationShape::parabolic ? 8 : 2 * std::numbers::pi;
  return turning * walls.frequency * walls.amplitude;
}

/// Of the wall of a case that oscillates, diameters/time^2.
inline double peak_acceleration(const Case::Walls& walls) {
  const double turning = 2 * std::numbers::pi;
  const double factor = walls.motion == OscillationShape::parabolic ? 32 : turning * turning;
  return factor * walls.frequency * walls.frequency * walls.amplitude;
}

}  // namespace zenosphere
