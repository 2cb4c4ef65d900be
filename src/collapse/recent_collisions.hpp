#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "model/archive.hpp"
#include "model/collision.hpp"

namespace zenosphere {

/// What the anatomy of a collapse keeps of a collision.
template <int Dim, class Real>
struct CollisionTrace {
  std::int64_t number = 0;
  Instant<Real> time;
  std::int32_t i = 0;
  std::int32_t j = 0;
  Vec<Dim, Real> normal;  ///< unit vector from i to j
  Real normal_speed = 0;  ///< diameters/time
  Real gap_before = 0;    ///< of this pair at the collision before, diameters

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.number, self.time, self.i, self.j, self.normal, self.normal_speed,
            self.gap_before);
  }
};

/// The last collisions of a run, and those before the clock stopped.
///
/// A *stretch* is a run of collisions in which every gap is at or below the threshold and no time
/// is later than that of the first (as in ArrestCriterion). In an arrest it goes on for ever; so it
/// has a memory of its own, and does not push out what led to it.
///
/// Nearly every collision is a stretch by itself. Its trace is written where it stays, in a ring as
/// small as it can be: what is written at every collision pushes spheres out of the caches.
template <int Dim, class Real>
class RecentCollisions {
 public:
  using Trace = CollisionTrace<Dim, Real>;

  /// \param threshold   gap in diameters
  /// \param clock_unit  of the simulation's clock
  RecentCollisions(const Real& threshold, const Real& clock_unit)
      : threshold_(threshold), clock_unit_(clock_unit), ring_(most_kept + 1) {}

  void observe(const Collision<Dim, Real>& collision) {
    const bool goes_on = length_ > 0 && collision.gap_before <= threshold_ &&
                         !(elapsed(start_, collision.time, clock_unit_) > 0);
    if (!goes_on) begin_stretch(collision.time);
    Trace& trace = goes_on ? next_of_stretch() : ring_[slot(first_)];
    ++length_;
    trace.number = collision.number;
    trace.time = collision.time;
    trace.i = collision.i;
    trace.j = collision.j;
    trace.normal = collision.impact.normal;
    trace.normal_speed = collision.impact.normal_speed;
    trace.gap_before = collision.gap_before;
  }

  bool is_empty() const { return length_ == 0; }

  /// How many of the traces lie before the last stretch.
  std::size_t before_stretch() const { return std::min(first_, most_kept); }

  /// All that is kept, in order; numbers may be left out before or within the last stretch.
  std::vector<Trace> traces() const {
    std::vector<Trace> all;
    for (std::size_t n = first_ - before_stretch(); n < first_; ++n) all.push_back(ring_[slot(n)]);
    const std::vector<Trace> rest = stretch();
    all.insert(all.end(), rest.begin(), rest.end());
    return all;
  }

  /// \throws ArchiveError for traces that cannot have been kept
  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.first_, self.length_, self.start_, self.stretch_);
    const bool is_possible = self.first_ <= std::size_t{most_counted} &&
                             self.length_ <= std::size_t{most_counted} &&
                             (self.length_ > 0 || self.first_ == 0) &&
                             self.stretch_.size() + 1 == std::max(self.kept(), std::size_t{1});
    require_archived(is_possible, "collisions that cannot have been kept");
    // Slots are used from the first one on.
    const std::size_t used = self.length_ > 0 ? std::min(self.first_ + 1, self.ring_.size()) : 0;
    for (std::size_t n = 0; n < used; ++n) archive(self.ring_[n]);
  }

 private:
  static constexpr std::size_t most_kept = 1024;  // of each kind: 75 KB in double

  /// Places count on, slots repeat.
  static std::size_t slot(std::size_t place) { return place % (most_kept + 1); }

  /// Collisions of the stretch that are kept: the last ones.
  std::size_t kept() const { return std::min(length_, most_kept); }

  /// Where the next collision of a stretch goes: a long stretch goes round.
  Trace& next_of_stretch() {
    const std::size_t n = length_ % most_kept;
    if (n == 0) return ring_[slot(first_)];
    if (n > stretch_.size()) stretch_.emplace_back();
    return stretch_[n - 1];
  }

  /// The last stretch, in order.
  std::vector<Trace> stretch() const {
    std::vector<Trace> all;
    const std::size_t oldest = length_ > most_kept ? length_ % most_kept : 0;
    for (std::size_t k = 0; k < kept(); ++k) {
      const std::size_t n = (oldest + k) % kept();
      all.push_back(n == 0 ? ring_[slot(first_)] : stretch_[n - 1]);
    }
    return all;
  }

  void begin_stretch(const Instant<Real>& start) {
    if (length_ > 1) {
      const std::vector<Trace> in_order = stretch();
      for (std::size_t n = 0; n < in_order.size(); ++n) ring_[slot(first_ + n)] = in_order[n];
      stretch_.clear();
    }
    first_ += kept();
    length_ = 0;
    start_ = start;
  }

  Real threshold_;
  Real clock_unit_;
  std::vector<Trace> ring_;     ///< what came before the stretch, and its first collision
  std::vector<Trace> stretch_;  ///< its other collisions
  std::size_t first_ = 0;       ///< place of the stretch
  std::size_t length_ = 0;      ///< collisions of the stretch, kept or not
  Instant<Real> start_;         ///< of the stretch
};

}  // namespace zenosphere
