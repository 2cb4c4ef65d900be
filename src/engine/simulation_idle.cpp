// What is done to a simulation between its collisions: it is kicked, it gets another frame, and
// where spheres are few and meet no other for long it is looked at whether anything will ever
// happen again, or goes on over many boxes in one step.

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>

#include "engine/patience.hpp"
#include "engine/rest.hpp"
#include "engine/simulation.hpp"
#include "engine/time_apart.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim, class Real>
void Simulation<Dim, Real>::kick(const std::vector<Vector>& changes) {
  assert(changes.size() == static_cast<std::size_t>(spheres()));
  shorten_stride();
  come_home();
  for (std::int32_t i = 0; i < spheres(); ++i) {
    const Vector& change = changes[static_cast<std::size_t>(i)];
    system_.spheres.advance(i, clock().remainder());
    if (grains().is_immobile(i)) continue;
    system_.spheres[i].velocity += change;
    predictor_.rewind_bound().note_change(change, clock().remainder());
  }
  at_rest_ = false;
  idle_events_ = 0;
  last_change_ = now();
  predictor_.rewind_bound().forget();
  if (system_.moving_walls) system_.moving_walls->forget_departures();
  predictor_.predict_all(system_);
}

/// Looks what is ahead of spheres that have long met no other: at times that make it cost little.
template <int Dim, class Real>
void Simulation<Dim, Real>::look_around() {
  const auto events = static_cast<std::uint64_t>(idle_events_);
  if (std::has_single_bit(events)) {
    look_for_rest();
    if (spheres() <= most_in_pairs && waits_in_vain())
      idle_events_ = most_idle_events(spheres()) + 1;
  }
  const auto pairs = static_cast<std::uint64_t>(spheres()) * static_cast<std::uint64_t>(spheres());
  const std::uint64_t between = std::bit_ceil(std::max<std::uint64_t>(pairs, 1024));
  const bool are_few = spheres() <= most_in_pairs;
  if (are_few && events % between == 0 && !at_rest_ && !box().is_sheared()) leap();
}

/// Notes whether no two ever meet, and otherwise lets the frame drift with the spheres where that
/// makes them slow, so that their lists need not be rebuilt so often.
template <int Dim, class Real>
void Simulation<Dim, Real>::look_for_rest() {
  const bool is_pushed = surroundings().walls && surroundings().walls->oscillation;
  const bool fly_straight = system_.spheres.acceleration() == Vector{};
  at_rest_ = fly_straight && !is_pushed &&
             ((!box().is_sheared() && move_as_one(system_)) || never_meet(system_));
  if (at_rest_ || box().is_sheared()) return;
  Vector mean;
  for (std::int32_t i = 0; i < spheres(); ++i) mean += system_.spheres[i].velocity;
  mean *= Real(1) / Real(spheres());
  for (int axis = 0; axis < Dim; ++axis) {
    if (!system_.frame.is_free(axis)) mean[axis] = 0;
  }
  if (2 * fastest_beside(system_, mean) <= fastest_beside(system_, Vector{})) move_frame(mean);
}

/// Whether it is certain, under shear, that no two meet before as many events have come as a run
/// waits for.
template <int Dim, class Real>
bool Simulation<Dim, Real>::waits_in_vain() const {
  if (!box().is_sheared() || at_rest_ || !system_.spheres.are_of_one_size()) return false;
  constexpr double margin = 1.25;  // events come about as often as before
  const auto waited = static_cast<double>(clock().since(last_change_));
  const double until = margin * waited * static_cast<double>(most_idle_events(spheres())) /
                       static_cast<double>(idle_events_);
  return stay_apart_sheared(system_, until);
}

/// Lets the frame drift faster, and all spheres in it slower.
template <int Dim, class Real>
void Simulation<Dim, Real>::move_frame(const Vector& change) {
  come_home();
  system_.frame.speed_up(change, now(), lees_edwards_offset());
  for (std::int32_t i = 0; i < spheres(); ++i) {
    system_.spheres.advance(i, clock().remainder());
    system_.spheres[i].velocity -= change;
  }
  predictor_.predict_all(system_);
}

/// Has no list rebuilt until shortly before two spheres can meet, or one a wall, where
/// that is so far off that it is worth it.
///
/// The clock stays where it is: only what is due next is put off, so that a run that stops or is
/// kicked before goes on from the same state. The fastest sphere is first then, and by far outside
/// of its ball: so rebuild_list() knows that all have to come home.
template <int Dim, class Real>
void Simulation<Dim, Real>::leap() {
  constexpr int balls_each = 16;  // that are crossed, at least
  // time_apart() knows upright grids, unit spheres and straight ways only.
  if (system_.spheres.sliding_box().has_displaced_images() || !system_.spheres.are_of_one_size())
    return;
  if (system_.spheres.some_are_held()) return;
  for (std::int32_t i = 0; i < spheres(); ++i) {
    const Meeting<Real>& first = predictor_.meetings(i).first();
    if (first.has_partner() && predictor_.is_stale(first, system_)) predictor_.predict(system_, i);
  }
  const std::int32_t leader = system_.fastest();
  const Real least = balls_each * Real(system_.search.reach()) / system_.speed(leader);
  constexpr double margin = 0x1p-32;
  Real longest = Real(longest_foreseen) / system_.speed(leader);
  for (std::int32_t i = 0; i < spheres(); ++i) {
    const Real& meeting = predictor_.meetings(i).first().time;
    longest = std::min(longest, Real(meeting - clock().remainder()));
  }
  const Real apart = certainly_apart(system_, longest, least) * Real(1 - margin);
  if (!(apart > least)) return;
  const Real then = clock().remainder() + apart;
  for (std::int32_t i = 0; i < spheres(); ++i) {
    predictor_.schedule_by(i, i == leader ? then : Real(then + least));
  }
}

/// Rebuilds the lists of all spheres, which may be anywhere, and finds their next meetings; where
/// none has met another for so short a time that all are at home, nothing.
template <int Dim, class Real>
void Simulation<Dim, Real>::come_home() {
  if (!is_idle() || box().is_sheared()) return;
  for (std::int32_t i = 0; i < spheres(); ++i) system_.spheres.bring_back(i, clock().remainder());
  for (std::int32_t i = 0; i < spheres(); ++i) {
    system_.search.place_anew(system_.spheres, i, clock().remainder());
  }
  for (std::int32_t i = 0; i < spheres(); ++i) {
    // Not stored anew where that is not needed: it is rounded.
    if (surroundings().walls) system_.spheres.advance(i, clock().remainder());
    predictor_.find_meetings(system_, i);
    predictor_.schedule(system_, i);
  }
}

template <int Dim, class Real>
bool Simulation<Dim, Real>::has_lost_places() const {
  const Real flown = system_.speed(system_.fastest()) * clock().since(last_change_);
  return flown * std::numeric_limits<Real>::epsilon() > 1;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                        \
  template void Simulation<Dim, Real>::kick(const std::vector<Vec<Dim, Real>>&); \
  template void Simulation<Dim, Real>::look_around();                            \
  template void Simulation<Dim, Real>::leap();                                   \
  template void Simulation<Dim, Real>::come_home();                              \
  template bool Simulation<Dim, Real>::has_lost_places() const;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
