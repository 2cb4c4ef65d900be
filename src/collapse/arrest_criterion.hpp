#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "model/collision.hpp"

namespace zenosphere {

/// The paper's criterion: over a window of collisions the clock stands still, every gap stays at
/// or below the threshold, and the pairs repeat.
///
/// Watched is the *stretch*: the longest run of collisions up to now in which every gap was at or
/// below the threshold and no collision came later than the first one. The criterion is met when
/// the stretch is at least a window long, its pairs have met `repetitions` times on average, and no
/// pair that is new to it has appeared during the last half window. Then the repeating pairs are
/// those of the last half window.
///
/// Source: "Detection of Inelastic Collapse in 3-D Shear Flow", its three conditions; the window
/// and the meaning of "repeat" are ours, since the paper gives no numbers.
template <int Dim, class Real>
class ArrestCriterion {
 public:
  using Pair = std::pair<std::int32_t, std::int32_t>;

  /// How often the pairs of a stretch must have met on average. A row of 20 pairs that comes close
  /// to collapse and opens again makes up to 13 rounds within one unit in the last place of the
  /// clock (e = 0.6, seeds 1 to 5); an arrest never ends.
  static constexpr std::int64_t enough_repetitions = 100;

  /// \param threshold    gap in diameters
  /// \param window       collisions, >= 2
  /// \param clock_unit   of the simulation's clock
  /// \param repetitions  of each pair on average
  ArrestCriterion(const Real& threshold, std::int64_t window, const Real& clock_unit,
                  std::int64_t repetitions = enough_repetitions)
      : threshold_(threshold),
        window_(window),
        clock_unit_(clock_unit),
        repetitions_(repetitions) {}

  void observe(const Collision<Dim, Real>& collision) {
    if (is_met()) return;
    const bool goes_on = stretch_start_ > 0 && collision.gap_before <= threshold_ &&
                         !(elapsed(start_time_, collision.time, clock_unit_) > 0);
    if (goes_on) {
      go_on(collision);
    } else {
      begin(collision);
    }
  }

  bool is_met() const { return collision_.has_value(); }
  std::int64_t window() const { return window_; }

  /// The collision at which the criterion was met for the first time, and its time.
  std::optional<std::int64_t> collision() const { return collision_; }
  std::optional<double> time() const { return time_; }

  /// The pairs that repeated then, in order.
  const std::vector<Pair>& pairs() const { return pairs_; }

  /// \throws ArchiveError for an arrest without pairs, or for pairs in the wrong order
  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.stretch_start_, self.newest_pair_, self.start_time_, self.seen_, self.collision_,
            self.time_, self.pairs_);
    require_counts(self.stretch_start_, self.newest_pair_, self.collision_);
    for (const Seen& seen : self.seen_) require_pair(seen.pair);
    for (const Pair& pair : self.pairs_) require_pair(pair);
    const bool is_met = self.collision_.has_value();
    require_archived(self.time_.has_value() == is_met && self.pairs_.empty() != is_met,
                     "an arrest that there is not");
  }

 private:
  struct Seen {
    Pair pair;
    std::int64_t last;  ///< number of its last collision

    template <class Self, class Archive>
    static void archive_state(Self& self, Archive& archive) {
      archive(self.pair, self.last);
    }
  };

  static void require_pair(const Pair& pair) {
    require_archived(pair.first >= 0 && pair.first < pair.second, "a pair that there is not");
  }

  /// Begins a stretch: nearly every collision does.
  void begin(const Collision<Dim, Real>& collision) {
    stretch_start_ = newest_pair_ = collision.number;
    start_time_ = collision.time;
    seen_.resize(1);
    seen_.front() = {{collision.i, collision.j}, collision.number};
  }
  void go_on(const Collision<Dim, Real>& collision);
  void remember(const Collision<Dim, Real>& collision);
  void conclude(const Collision<Dim, Real>& collision);

  Real threshold_;
  std::int64_t window_;
  Real clock_unit_;
  std::int64_t repetitions_;

  std::int64_t stretch_start_ = 0;  ///< number of the first collision of the stretch
  std::int64_t newest_pair_ = 0;    ///< number of the collision that brought the last new pair
  Instant<Real> start_time_;
  std::vector<Seen> seen_;  ///< pairs of the stretch, sorted

  std::optional<std::int64_t> collision_;
  std::optional<double> time_;
  std::vector<Pair> pairs_;
};

}  // namespace zenosphere
