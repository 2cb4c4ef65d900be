#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "engine/simulation.hpp"
#include "io/case.hpp"
#include "run/random_driving.hpp"

namespace zenosphere {

/// When a run of a case is over if nothing ends it before: run.time, or the end of the clock. It
/// goes on to run.time, but stays at its last event where only the end of the clock is left.
template <class Real>
double last_moment(const Case& values) {
  return std::min(values.run.time.value_or(std::numeric_limits<double>::max()),
                  end_of_clock<Real>());
}

/// Events without a collision after which a run without run.time is given up.
inline std::int64_t most_idle_events(std::int32_t spheres) {
  constexpr std::int64_t at_least = std::int64_t{1} << 28;  // a minute or two
  constexpr std::int64_t per_sphere = std::int64_t{1} << 20;
  return at_least + per_sphere * spheres;
}

/// Why a run comes to no further collision, whatever its limits: as docs/summary.md names it, or
/// nullptr where it may.
template <int Dim, class Real>
const char* end_of_collisions(const Simulation<Dim, Real>& simulation,
                              const RandomDriving<Dim, Real>& driving) {
  if (simulation.stopped_before()) return "overlap";
  return simulation.is_at_rest() && !driving.is_on() ? "at rest" : nullptr;
}

/// Why a run is over by its time or that of its clock, or because nobody meets for too long, or
/// until no digit of the places is left; nullptr where it is not.
template <int Dim, class Real>
const char* end_of_time(const Simulation<Dim, Real>& simulation, const Case& values) {
  const auto& time = values.run.time;
  if (time && simulation.has_reached(*time)) return "time";
  if (simulation.has_reached(end_of_clock<Real>())) return "clock";
  if (time || !simulation.is_idle()) return nullptr;
  const bool is_too_long = simulation.idle_events() > most_idle_events(simulation.spheres());
  return is_too_long || simulation.has_lost_places() ? "idle" : nullptr;
}

}  // namespace zenosphere
