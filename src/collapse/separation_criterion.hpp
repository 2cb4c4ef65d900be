#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "model/collision.hpp"
#include "model/field.hpp"

namespace zenosphere {

/// How often the separation criterion was met, and when. Times since the start.
struct SeparationResult {
  std::int64_t hits = 0;
  std::optional<std::int64_t> first_collision;
  std::optional<double> first_time;
  std::optional<std::int64_t> last_collision;
  std::optional<double> last_time;  ///< absent from files of older versions
  double longest_pause = 0;         ///< the longest time between two hits; 0: there are not two

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(Field{"hits", "separation_hits"}, self.hits);
    visit(Field{"first_collision", "separation_first_collision"}, self.first_collision);
    visit(Field{"first_time", "separation_first_time"}, self.first_time);
    visit(Field{"last_collision", "separation_last_collision"}, self.last_collision);
    visit(Field{.name = "last_time", .may_lack = true}, self.last_time);
    visit(Field{.name = "longest_pause", .may_lack = true}, self.longest_pause);
  }
};

/// The traditional criterion: after a collision, the pair that will collide next is closer, now,
/// than a threshold.
///
/// A collision carries the gap that its pair had when the collision before was done; so the
/// criterion is met *at* that earlier collision, and is known one collision later.
///
/// Source: McNamara & Young, Phys. Rev. E 50 (1994) R28.
template <int Dim, class Real>
class SeparationCriterion {
 public:
  /// \param threshold   gap in diameters
  /// \param clock_unit  of the simulation's clock
  SeparationCriterion(const Real& threshold, const Real& clock_unit)
      : threshold_(threshold), clock_unit_(clock_unit) {}

  void observe(const Collision<Dim, Real>& collision) {
    observe_next(collision.gap_before);
    collision_ = collision.number;
    time_ = exactly_since_start(collision.time, clock_unit_);
  }

  /// The gap, at the collision observed last, of the pair that collides next.
  ///
  /// To be called where a run ends and that pair is known without its collision. Before the first
  /// collision there is none at which the criterion could be met.
  void observe_next(const Real& gap) {
    if (collision_ == 0 || gap > threshold_) return;
    ++hits_;
    last_collision_ = collision_;
    const auto now = static_cast<double>(time_);
    longest_pause_ = std::max(longest_pause_, now - last_time_.value_or(now));
    last_time_ = now;
    if (hits_ > 1) return;
    first_collision_ = collision_;
    first_time_ = time_;
  }

  std::int64_t hits() const { return hits_; }
  std::optional<std::int64_t> first_collision() const { return first_collision_; }
  const std::optional<Real>& first_time() const { return first_time_; }
  std::optional<std::int64_t> last_collision() const { return last_collision_; }
  std::optional<double> last_time() const { return last_time_; }

  SeparationResult result() const {
    SeparationResult result;
    result.hits = hits_;
    result.first_collision = first_collision_;
    result.last_collision = last_collision_;
    result.last_time = last_time_;
    result.longest_pause = longest_pause_;
    if (first_time_) result.first_time = static_cast<double>(*first_time_);
    return result;
  }

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.collision_, self.time_, self.hits_, self.first_collision_, self.first_time_,
            self.last_collision_, self.last_time_, self.longest_pause_);
    require_counts(self.collision_, self.hits_, self.first_collision_, self.last_collision_);
  }

 private:
  Real threshold_;
  Real clock_unit_;
  std::int64_t collision_ = 0;  ///< the one observed last
  Real time_ = 0;               ///< its time
  std::int64_t hits_ = 0;
  std::optional<std::int64_t> first_collision_;
  std::optional<Real> first_time_;
  std::optional<std::int64_t> last_collision_;
  std::optional<double> last_time_;
  double longest_pause_ = 0;
};

}  // namespace zenosphere
