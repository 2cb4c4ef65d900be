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
/// has half of the memory, and does not push out what led to it.
template <int Dim, class Real>
class RecentCollisions {
 public:
  using Trace = CollisionTrace<Dim, Real>;

  /// \param threshold   gap in diameters
  /// \param clock_unit  of the simulation's clock
  RecentCollisions(const Real& threshold, const Real& clock_unit)
      : threshold_(threshold), clock_unit_(clock_unit), traces_(2 * most_kept) {}

  void observe(const Collision<Dim, Real>& collision) {
    const bool goes_on = length_ > 0 && collision.gap_before <= threshold_ &&
                         !(elapsed(start_, collision.time, clock_unit_) > 0);
    if (!goes_on) begin_stretch(collision.time);
    Trace& trace = slot(length_ < most_kept ? end_++ : first_ + length_ % most_kept);
    ++length_;
    trace.number = collision.number;
    trace.time = collision.time;
    trace.i = collision.i;
    trace.j = collision.j;
    trace.normal = collision.impact.normal;
    trace.normal_speed = collision.impact.normal_speed;
    trace.gap_before = collision.gap_before;
  }

  bool is_empty() const { return end_ == 0; }

  /// How many of the traces lie before the last stretch.
  std::size_t before_stretch() const { return first_ < most_kept ? first_ : most_kept; }

  /// All that is kept, in order; numbers may be left out before or within the last stretch.
  std::vector<Trace> traces() const {
    std::vector<Trace> all;
    for (std::size_t n = first_ - before_stretch(); n < first_; ++n) all.push_back(slot(n));
    const std::vector<Trace> rest = stretch();
    all.insert(all.end(), rest.begin(), rest.end());
    return all;
  }

  /// \throws ArchiveError for traces that cannot have been kept
  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.first_, self.end_, self.length_, self.start_);
    const bool is_possible = self.first_ <= self.end_ && self.end_ <= std::size_t{most_counted} &&
                             self.end_ - self.first_ == std::min(self.length_, most_kept);
    require_archived(is_possible, "collisions that cannot have been kept");
    // Slots are used from the first one on.
    for (std::size_t n = 0; n < std::min(self.end_, 2 * most_kept); ++n) archive(self.traces_[n]);
  }

 private:
  static constexpr std::size_t most_kept = 1024;  // of each kind: together 150 KB in double

  Trace& slot(std::size_t place) { return traces_[place % (2 * most_kept)]; }
  const Trace& slot(std::size_t place) const { return traces_[place % (2 * most_kept)]; }

  /// The last stretch, in order: a long one has gone round in its half.
  std::vector<Trace> stretch() const {
    std::vector<Trace> all;
    const std::size_t oldest = length_ > most_kept ? length_ % most_kept : 0;
    const std::size_t kept = end_ - first_;
    for (std::size_t n = 0; n < kept; ++n) all.push_back(slot(first_ + (oldest + n) % kept));
    return all;
  }

  void begin_stretch(const Instant<Real>& start) {
    if (length_ > most_kept) {
      const std::vector<Trace> in_order = stretch();
      for (std::size_t n = 0; n < in_order.size(); ++n) slot(first_ + n) = in_order[n];
    }
    first_ = end_;
    length_ = 0;
    start_ = start;
  }

  Real threshold_;
  Real clock_unit_;
  std::vector<Trace> traces_;
  std::size_t first_ = 0;   ///< place of the stretch; places count on, slots repeat
  std::size_t end_ = 0;     ///< place behind the last trace
  std::size_t length_ = 0;  ///< collisions of the stretch, kept or not
  Instant<Real> start_;     ///< of the stretch
};

}  // namespace zenosphere
