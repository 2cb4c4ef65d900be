#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "engine/spheres.hpp"
#include "model/archive.hpp"
#include "model/rewind.hpp"

namespace zenosphere {

/// How far `rewind` may set the clock back, so that no sphere is put further off the course that it
/// was on than by longest_way_back().
///
/// By the time in which the fastest sphere flies that way, and not to before the moment to which a
/// sphere whose velocity has changed would be off by it. The second bound holds where all come to
/// rest, and keeps steps back from adding up. An overlap that closes at slowest() or below is no
/// approach: it collides now. The fastest sphere is looked for once in as many collisions as there
/// are spheres, and only when two overlap.
///
/// Source: docs/decisions/0016-rewind-within-the-digits.md.
template <int Dim, class Real>
class RewindBound {
 public:
  RewindBound(const ShearBox<Dim, Real>& box, const Vec<Dim, Real>& acceleration,
              const Real& largest_diameter = Real(1)) {
    using std::abs;
    Real longest_side = 0;
    for (int axis = 0; axis < Dim; ++axis) longest_side = std::max(longest_side, box.sides()[axis]);
    distance_ =
        longest_way_back(longest_side, std::numeric_limits<Real>::epsilon(), largest_diameter);
    Real pull = 0;  // at most sqrt(3) times the size of the acceleration, and no square of it
    for (int axis = 0; axis < Dim; ++axis) pull += abs(acceleration[axis]);
    const Real slide = box.slide_speed() / 2;
    least_square_ = 2 * pull * longest_side + slide * slide;
  }

  /// Looks for the fastest sphere at `when`, if that has not been done lately.
  void renew(const Spheres<Dim, Real>& spheres, const Real& when, std::int64_t collisions) {
    using std::sqrt;
    if (collisions < next_look_) return;
    const bool is_first = next_look_ == 0;
    constexpr std::int64_t least_between = 16;  // one collision must not see two looks
    next_look_ = collisions + std::max<std::int64_t>(least_between, spheres.count());
    Real square = 0;
    for (std::int32_t i = 0; i < spheres.count(); ++i) {
      const Vec<Dim, Real> velocity = spheres.velocity_at(i, when);
      square = std::max(square, static_cast<Real>(dot(velocity, velocity)));
    }
    const Real fastest = sqrt(static_cast<Real>(square + least_square_));
    before_ = is_first ? fastest : fastest_;
    fastest_ = fastest;
  }

  /// Has the fastest sphere looked for again: velocities have changed otherwise than by collisions.
  void forget() { next_look_ = 0; }

  /// To be called for each change of a velocity: a sphere goes back along its new course only.
  void note_change(const Vec<Dim, Real>& change, const Real& when) {
    using std::sqrt;
    const Real square = dot(change, change);
    if (!(square > 0)) return;
    const Real size = sqrt(square);
    largest_change_ = std::max(largest_change_, size);
    earliest_ = std::max(earliest_, Real(when - distance_ / size));
  }

  /// The closing speed that the rounding of velocities can have made: below it an overlap does not
  /// tell when the two have met.
  Real slowest() const { return 64 * std::numeric_limits<Real>::epsilon() * largest_change_; }

  /// Shifts its times by `span`.
  void shift_times(const Real& span) { earliest_ -= span; }

  /// The longest step back at `now`, in the unit of the velocities: at least 0.
  Real longest(const Real& now) const { return std::min(longest(), Real(now - earliest_)); }

  /// The same as far as the fastest sphere limits it.
  Real longest() const { return duration_at(fastest_); }

  /// What the clock has not gone, and will not go, back behind.
  const Real& earliest() const { return earliest_; }

  /// The same at any moment since the collision before the last.
  Real longest_lately() const { return duration_at(std::min(fastest_, before_)); }

  /// \throws ArchiveError where no sphere can be that fast
  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.fastest_, self.before_, self.next_look_, self.earliest_, self.largest_change_);
    require_archived(self.fastest_ >= 0 && self.before_ >= 0 && self.largest_change_ >= 0,
                     "a speed that there is not");
    require_archived(self.earliest_ < std::numeric_limits<Real>::infinity(),
                     "a time that there is not");
    require_counts(self.next_look_);
  }

 private:
  /// Where nothing moves, no two overlap while approaching.
  Real duration_at(const Real& speed) const {
    return speed > 0 ? Real(distance_ / speed) : Real(0);
  }

  Real distance_;  ///< diameters
  Real
      least_square_;  ///< of the speeds after a fall through the box, and of half a slide of layers
  Real fastest_ = 0;
  Real before_ = 0;                                         ///< the fastest at the look before
  Real earliest_ = -std::numeric_limits<Real>::infinity();  ///< remainder of the clock
  Real largest_change_ = 0;                                 ///< of a velocity so far
  std::int64_t next_look_ = 0;                              ///< number of collisions
};

}  // namespace zenosphere
