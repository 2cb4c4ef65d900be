// What is done to a simulation between its collisions: it is kicked, it gets another frame, and
// it is looked at whether anything will ever happen again.

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

#include "engine/patience.hpp"
#include "engine/simulation.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

constexpr std::int32_t most_in_pairs = 1000;  ///< spheres of which all pairs can be looked at

}  // namespace

template <int Dim, class Real>
void Simulation<Dim, Real>::kick(const std::vector<Vector>& changes) {
  assert(changes.size() == meetings_.size());
  shorten_stride();
  come_home();
  for (std::int32_t i = 0; i < spheres(); ++i) {
    const Vector& change = changes[static_cast<std::size_t>(i)];
    spheres_.advance(spheres_[i], now_.remainder);
    if (grains().is_immobile(i)) continue;
    spheres_[i].velocity += change;
    rewind_bound_.note_change(change, now_.remainder);
  }
  at_rest_ = false;
  idle_events_ = 0;
  last_change_ = now_;
  rewind_bound_.forget();
  if (moving_walls_) moving_walls_->forget_departures();
  for (std::int32_t i = 0; i < spheres(); ++i) predict(i);
}

/// Looks what is ahead of spheres that have long met nobody: at times that make it cost little.
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

/// Notes whether nobody ever meets, and otherwise lets the frame drift with the spheres where that
/// makes them slow, so that they need not be settled so often.
template <int Dim, class Real>
void Simulation<Dim, Real>::look_for_rest() {
  const bool is_pushed = surroundings_.walls && surroundings_.walls->oscillation;
  const bool fly_straight = spheres_.acceleration() == Vector{};
  at_rest_ =
      fly_straight && !is_pushed && ((!box().is_sheared() && move_as_one()) || nobody_meets());
  if (at_rest_ || box().is_sheared()) return;
  Vector mean;
  for (std::int32_t i = 0; i < spheres(); ++i) mean += spheres_[i].velocity;
  mean *= Real(1) / Real(spheres());
  for (int axis = 0; axis < Dim; ++axis) {
    if (!frame_.is_free(axis)) mean[axis] = 0;
  }
  if (2 * fastest_beside(mean) <= fastest_beside({})) move_frame(mean);
}

/// Whether nothing is left of the relative velocities but what rounding makes of equal ones.
template <int Dim, class Real>
bool Simulation<Dim, Real>::move_as_one() const {
  using std::abs;
  const Vector& first = spheres_[0].velocity;
  for (int axis = 0; axis < Dim; ++axis) {
    if (!frame_.is_free(axis) && first[axis] != 0) return false;
    const Real rounding = 2 * std::numeric_limits<Real>::epsilon() * abs(first[axis]);
    for (std::int32_t i = 1; i < spheres(); ++i) {
      if (abs(spheres_[i].velocity[axis] - first[axis]) > rounding) return false;
    }
  }
  return true;
}

/// The largest component, along the axes along which the frame may move, of the velocities relative
/// to the given one.
template <int Dim, class Real>
Real Simulation<Dim, Real>::fastest_beside(const Vector& velocity) const {
  using std::abs;
  Real fastest = 0;
  for (std::int32_t i = 0; i < spheres(); ++i) {
    const Vector relative = spheres_[i].velocity - velocity;
    for (int axis = 0; axis < Dim; ++axis) {
      if (frame_.is_free(axis)) fastest = std::max(fastest, Real(abs(relative[axis])));
    }
  }
  return fastest;
}

/// Lets the frame drift faster, and all spheres in it slower.
template <int Dim, class Real>
void Simulation<Dim, Real>::move_frame(const Vector& change) {
  come_home();
  frame_.speed_up(change, now_, lees_edwards_offset());
  for (std::int32_t i = 0; i < spheres(); ++i) {
    spheres_.advance(spheres_[i], now_.remainder);
    spheres_[i].velocity -= change;
  }
  for (std::int32_t i = 0; i < spheres(); ++i) predict(i);
}

/// Whether it is certain that no sphere ever meets another one or a wall.
template <int Dim, class Real>
bool Simulation<Dim, Real>::nobody_meets() const {
  if (spheres() > most_in_pairs) return false;
  for (std::int32_t i = 0; i < spheres(); ++i) {
    if (const auto axis = box().closed_axis(); axis && spheres_[i].velocity[*axis] != 0)
      return false;
    for (std::int32_t j = 0; j < i; ++j) {
      if (may_meet(i, j)) return false;
    }
  }
  return true;
}

/// Whether two spheres that fly straight may meet in some image: not where they are apart across
/// the axes along which they move, for good. Along several axes at once they come close one day.
/// Under shear all images but one move along x, and there they may lie anywhere in a box whose
/// images are displaced.
template <int Dim, class Real>
bool Simulation<Dim, Real>::may_meet(std::int32_t i, std::int32_t j) const {
  const Vector velocity = spheres_[j].velocity - spheres_[i].velocity;
  const bool is_one_frame = !box().is_sheared() || spheres_.share_layer(i, j);
  if (velocity == Vector{} && is_one_frame) return false;
  Vector across = spheres_.shortest_image(spheres_.position_at(spheres_[j], now_.remainder) -
                                              spheres_.position_at(spheres_[i], now_.remainder),
                                          now_.remainder);
  for (int axis = 0; axis < Dim; ++axis) {
    const bool is_displaced = box().is_sheared() || spheres_.has_displaced_images();
    if (velocity[axis] != 0 || (axis == 0 && is_displaced)) across[axis] = 0;
  }
  const Real margin = approach_margin;
  const Real sigma = spheres_.sigma(i, j);
  return dot(across, across) < sigma * sigma + margin;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                        \
  template void Simulation<Dim, Real>::kick(const std::vector<Vec<Dim, Real>>&); \
  template void Simulation<Dim, Real>::look_around();                            \
  template bool Simulation<Dim, Real>::move_as_one() const;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
