#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/calendar.hpp"
#include "engine/contact_rules.hpp"
#include "engine/contacts_ahead.hpp"
#include "engine/huge_page_vector.hpp"
#include "engine/next_meetings.hpp"
#include "engine/rewind_bound.hpp"
#include "engine/system.hpp"

namespace zenosphere {

/// What comes: the next meetings of each sphere, and its event in the calendar, which is the first
/// of them or the moment at which its neighbour list has to be rebuilt.
///
/// A pair is looked after by the sphere that was predicted later. A meeting whose partner has
/// collided since is stale. The system is handed to each call: it is the one that has been
/// predicted.
template <int Dim, class Real>
class Predictor {
 public:
  Predictor(const System<Dim, Real>& system, const ContactRules<Real>& rules);

  const NextMeetings<Real>& meetings(std::int32_t i) const {
    return meetings_[static_cast<std::size_t>(i)];
  }
  const Calendar<Real>& calendar() const { return calendar_; }
  Calendar<Real>& calendar() { return calendar_; }

  /// Stores a sphere as it is now, finds its next meetings, and schedules the first event.
  void predict(System<Dim, Real>& system, std::int32_t i) {
    system.spheres.advance(i, system.clock.remainder());
    find_meetings(system, i);
    schedule(system, i);
  }
  void predict_all(System<Dim, Real>& system) {
    for (std::int32_t i = 0; i < system.count(); ++i) predict(system, i);
  }

  /// Finds the next meetings of a sphere that is stored as it is now.
  void find_meetings(const System<Dim, Real>& system, std::int32_t i);
  /// Adds the meetings with new neighbours to those that are known, and schedules the first event.
  void add_meetings(System<Dim, Real>& system, std::int32_t i,
                    std::span<const Neighbour> neighbours);
  /// Puts the first event of a sphere into the calendar.
  void schedule(System<Dim, Real>& system, std::int32_t i);
  /// Puts the first meeting of a sphere into the calendar, or an earlier time: its list need not be
  /// rebuilt before.
  void schedule_by(std::int32_t i, const Real& latest) {
    calendar_.schedule(i, std::min(meetings(i).first().time, latest));
  }

  /// Whether the partner of a meeting has collided with another one since; or is a wall that the
  /// sphere has yet to come within reach of.
  bool is_stale(const Meeting<Real>& meeting, const System<Dim, Real>& system) const;
  /// Whether it is known what comes in place of the first meeting: the second one, or none where
  /// that was all.
  bool is_second_known(const NextMeetings<Real>& next, const System<Dim, Real>& system) const;
  /// Finds what comes in place of the first meeting of a sphere, which is stale: now is its time.
  void replace_stale(System<Dim, Real>& system, std::int32_t i);

  /// All times count from so much later on.
  void shift_times(const Real& span);

  /// What bounds the steps back of the clock.
  const RewindBound<Dim, Real>& rewind_bound() const { return rewind_bound_; }
  RewindBound<Dim, Real>& rewind_bound() { return rewind_bound_; }
  /// Predictions that OverlapRule::guarded let pass.
  const std::int64_t& overlaps_ignored() const { return overlaps_ignored_; }
  std::int64_t& overlaps_ignored() { return overlaps_ignored_; }

  /// The pending events, to archives.
  void archive_events_to(ArchiveWriter& archive) const;
  /// The same from archives; the times go to the calendar once the clock is known. Throws
  /// ArchiveError for those of another number of spheres.
  std::vector<Real> read_meetings(const System<Dim, Real>& system, ArchiveReader& archive);
  /// Throws ArchiveError where a sphere has an event that no prediction makes.
  void schedule_archived(const System<Dim, Real>& system, const std::vector<Real>& times);
  /// What no event is before: overlaps lead into the past, which the clock counts from its last
  /// whole stride. Ten thousand strides, and as many of the longest rewinds, are far beyond what
  /// runs do.
  Real earliest_time(const StrideClock<Real>& clock) const {
    return -10000 * (clock.span() + rewind_bound_.longest());
  }

 private:
  Meeting<Real> meeting(const System<Dim, Real>& system, std::int32_t j, const Real& time) const {
    return j < 0 ? Meeting<Real>() : Meeting<Real>(time, j, system.spheres[j].collisions, false);
  }
  NextMeetings<Real> one_by_one(const System<Dim, Real>& system, std::int32_t i,
                                std::span<const Neighbour> neighbours);
  NextMeetings<Real> in_parts(const System<Dim, Real>& system, std::int32_t i,
                              std::span<const Neighbour> neighbours);
  NextMeetings<Real> with_walls(const System<Dim, Real>& system, std::int32_t i);
  Meeting<Real> with_oscillating_wall(const System<Dim, Real>& system, std::int32_t i) const;
  NextMeetings<Real> first_ahead(const System<Dim, Real>& system, std::int32_t i);
  NextMeetings<Real> with_heavy_partners(const System<Dim, Real>& system, std::int32_t i);
  void apply_overlap_rule(const System<Dim, Real>& system);
  void limit_rewinds(const System<Dim, Real>& system);
  void require_possible(const System<Dim, Real>& system, std::int32_t i) const;
  NextMeetings<Real>& pending(std::int32_t i) { return meetings_[static_cast<std::size_t>(i)]; }

  OverlapRule overlap_;
  Real guard_;  ///< see ContactRules
  Calendar<Real> calendar_;
  HugePageVector<NextMeetings<Real>> meetings_;
  RewindBound<Dim, Real> rewind_bound_;
  std::int64_t overlaps_ignored_ = 0;
  ContactsAhead<Real> ahead_;  ///< scratch
};

}  // namespace zenosphere
