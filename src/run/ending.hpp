#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

#include "case/case.hpp"
#include "engine/patience.hpp"
#include "engine/simulation.hpp"
#include "result/ended_by.hpp"
#include "run/random_driving.hpp"

namespace zenosphere {

/// When a run of a case is over if nothing ends it before: run.time, or the end of the clock. It
/// goes on to run.time, but stays at its last event where only the end of the clock is left.
template <class Real>
double last_moment(const Case& values) {
  return std::min(values.run.time.value_or(std::numeric_limits<double>::max()),
                  end_of_clock<Real>());
}

/// Why a run comes to no further collision, whatever its limits; nothing where it may.
template <int Dim, class Real>
std::optional<EndedBy> end_of_collisions(const Simulation<Dim, Real>& simulation,
                                         const RandomDriving<Dim, Real>& driving) {
  if (simulation.stopped_before()) return EndedBy::overlap;
  if (simulation.is_at_rest() && !driving.is_on()) return EndedBy::at_rest;
  return std::nullopt;
}

/// Whether no spheres have met for too long: for too many events, or kicks of a sphere.
template <int Dim, class Real>
bool is_given_up(const Simulation<Dim, Real>& simulation, const Case& values) {
  constexpr double events_a_kick = 8;  // in work
  const auto most = static_cast<double>(most_idle_events(simulation.spheres()));
  auto events = static_cast<double>(simulation.idle_events());
  if (values.drive.kind == DriveKind::random) {
    const double kicks = simulation.time_since_collision() / values.drive.kick_interval;
    events += events_a_kick * kicks * simulation.spheres();
  }
  return events > most;
}

/// Why a run is over by its time or that of its clock, or because no spheres meet for too long, or
/// until no digit of the places is left; nothing where it is not.
template <int Dim, class Real>
std::optional<EndedBy> end_of_time(const Simulation<Dim, Real>& simulation, const Case& values) {
  const auto& time = values.run.time;
  if (time && simulation.has_reached(*time)) return EndedBy::time;
  if (simulation.has_reached(end_of_clock<Real>())) return EndedBy::clock;
  const bool may_be_idle = simulation.is_idle() || values.drive.kind == DriveKind::random;
  if (time || !may_be_idle) return std::nullopt;
  const bool has_lost = simulation.is_idle() && simulation.has_lost_places();
  if (has_lost || is_given_up(simulation, values)) return EndedBy::idle;
  return std::nullopt;
}

}  // namespace zenosphere
