// How a simulation goes on over many boxes in one step, where spheres are few and meet nobody.

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/patience.hpp"
#include "engine/simulation.hpp"
#include "engine/time_apart.hpp"
#include "engine/time_apart_sheared.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

/// How sphere i sees sphere j in the laboratory.
template <int Dim, class Real>
ShearedFlight<Dim> flight_between(const Configuration<Dim, Real>& state, std::size_t i,
                                  std::size_t j, const ShearBox<Dim, Real>& box) {
  const Vec<Dim, Real> way = state.positions[j] - state.positions[i];
  Vec<Dim, Real> velocity = state.velocities[j] - state.velocities[i];  // peculiar
  velocity[0] += box.shear_rate() * way[1];
  ShearedFlight<Dim> flight{};
  for (int axis = 0; axis < Dim; ++axis) {
    flight.way[axis] = static_cast<double>(way[axis]);
    flight.velocity[axis] = static_cast<double>(velocity[axis]);
    flight.sides[static_cast<std::size_t>(axis)] = static_cast<double>(box.sides()[axis]);
  }
  flight.slide = static_cast<double>(box.shear_rate() * box.sides()[1]);
  return flight;
}

}  // namespace

/// Lets nobody be settled again until shortly before two spheres can meet, or one a wall, where
/// that is so far off that it is worth it.
///
/// The clock stays where it is: only what is due next is put off, so that a run that stops or is
/// kicked before goes on from the same state. The fastest sphere is first then, and by far outside
/// of its ball: so settle() knows that all have to come home.
template <int Dim, class Real>
void Simulation<Dim, Real>::leap() {
  constexpr int balls_each = 16;  // that are crossed, at least
  // time_apart() knows upright grids, unit spheres and straight ways only.
  if (spheres_.has_displaced_images() || !spheres_.are_of_one_size()) return;
  if (spheres_.some_are_held()) return;
  for (std::int32_t i = 0; i < spheres(); ++i) {
    const Meeting<Real>& first = meetings(i).first();
    if (first.is_with_anybody() && is_stale(first)) predict(i);
  }
  const std::int32_t leader = fastest();
  const Real least = balls_each * Real(spheres_.reach()) / speed(leader);
  constexpr double margin = 0x1p-32;
  const Real apart = certainly_apart(least) * Real(1 - margin);
  if (!(apart > least)) return;
  const Real then = now_.remainder + apart;
  for (std::int32_t i = 0; i < spheres(); ++i) {
    const Real due = i == leader ? then : Real(then + least);
    calendar_.schedule(i, std::min(meetings(i).first().time, due));
  }
}

/// Time for which nobody certainly meets anybody, as far as that can be foreseen: of a time below
/// `least` only that it is.
template <int Dim, class Real>
Real Simulation<Dim, Real>::certainly_apart(const Real& least) const {
  const Real fastest = speed(this->fastest());
  Real apart = Real(longest_foreseen) / fastest;
  for (std::int32_t i = 0; i < spheres(); ++i) {
    apart = std::min(apart, Real(meetings(i).first().time - now_.remainder));
  }
  const int pairs = spheres() * (spheres() - 1) / 2;
  const int searches = std::max(8, 4096 / std::max(pairs, 1));
  StraightFlight<Dim> flight{};
  flight.speed = 1;  // in units of the fastest
  for (int axis = 0; axis < Dim; ++axis) {
    flight.periods[static_cast<std::size_t>(axis)] = box().is_closed(axis)
                                                         ? std::numeric_limits<double>::infinity()
                                                         : static_cast<double>(box().sides()[axis]);
  }
  for (std::int32_t i = 0; i < spheres(); ++i) {
    for (std::int32_t j = 0; j < i && apart > least; ++j) {
      const Vector way = spheres_.position_at(spheres_[j], now_.remainder) -
                         spheres_.position_at(spheres_[i], now_.remainder);
      const Vector velocity = spheres_.velocity_at(spheres_[j], now_.remainder) -
                              spheres_.velocity_at(spheres_[i], now_.remainder);
      for (int axis = 0; axis < Dim; ++axis) {
        flight.way[axis] = static_cast<double>(way[axis]);
        flight.velocity[axis] = static_cast<double>(Real(velocity[axis] / fastest));
      }
      const auto until = static_cast<double>(Real(apart * fastest));
      apart = std::min(apart, Real(Real(time_apart(flight, until, searches)) / fastest));
    }
  }
  return apart;
}

/// Settles all spheres, which may be anywhere, and finds whom they meet; where nobody has met
/// anybody for so short a time that all are at home, nothing.
template <int Dim, class Real>
void Simulation<Dim, Real>::come_home() {
  if (!is_idle() || box().is_sheared()) return;
  for (std::int32_t i = 0; i < spheres(); ++i) spheres_.bring_back(i, now_.remainder);
  for (std::int32_t i = 0; i < spheres(); ++i) {
    spheres_.settle_anew(i, now_.remainder);
  }
  for (std::int32_t i = 0; i < spheres(); ++i) {
    // Not stored anew where that is not needed: it is rounded.
    if (surroundings_.walls) spheres_.advance(spheres_[i], now_.remainder);
    look_ahead(i);
    schedule(i);
  }
}

/// Whether it is certain, under shear, that nobody meets before as many events have come as a run
/// waits for.
template <int Dim, class Real>
bool Simulation<Dim, Real>::waits_in_vain() const {
  if constexpr (Dim == 1) {
    return false;
  } else {
    if (!box().is_sheared() || at_rest_ || !spheres_.are_of_one_size()) return false;
    constexpr double margin = 1.25;  // events come about as often as before
    const auto waited = static_cast<double>(elapsed(last_change_, now_, box().clock_unit()));
    const double until = margin * waited * static_cast<double>(most_idle_events(spheres())) /
                         static_cast<double>(idle_events_);
    const Configuration<Dim, Real> state = configuration();
    for (std::size_t i = 0; i < state.positions.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        ShearedFlight<Dim> flight = flight_between(state, i, j, box());
        flight.offset = static_cast<double>(lees_edwards_offset());
        if (time_apart_sheared(flight, until) < until) return false;
      }
    }
    return true;
  }
}

/// Of a sphere now, diameters/time; in its layer.
template <int Dim, class Real>
Real Simulation<Dim, Real>::speed(std::int32_t i) const {
  using std::sqrt;
  const Vector velocity = spheres_.velocity_at(spheres_[i], now_.remainder);
  return sqrt(dot(velocity, velocity));
}

/// The fastest sphere; of several the first.
template <int Dim, class Real>
std::int32_t Simulation<Dim, Real>::fastest() const {
  std::int32_t fastest = 0;
  for (std::int32_t i = 1; i < spheres(); ++i) {
    if (speed(i) > speed(fastest)) fastest = i;
  }
  return fastest;
}

template <int Dim, class Real>
double Simulation<Dim, Real>::time_since_collision() const {
  return static_cast<double>(elapsed(last_collision_, now_, box().clock_unit()));
}

template <int Dim, class Real>
bool Simulation<Dim, Real>::has_lost_places() const {
  const Real flown = speed(fastest()) * elapsed(last_change_, now_, box().clock_unit());
  return flown * std::numeric_limits<Real>::epsilon() > 1;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                              \
  template void Simulation<Dim, Real>::leap();                         \
  template void Simulation<Dim, Real>::come_home();                    \
  template bool Simulation<Dim, Real>::waits_in_vain() const;          \
  template double Simulation<Dim, Real>::time_since_collision() const; \
  template bool Simulation<Dim, Real>::has_lost_places() const;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
