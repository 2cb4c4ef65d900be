#pragma once

#include <cstdint>
#include <optional>

#include "model/collision.hpp"

namespace zenosphere {

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
  SeparationCriterion(double threshold, const Real& clock_unit)
      : threshold_(threshold), clock_unit_(clock_unit) {}

  void observe(const Collision<Dim, Real>& collision) {
    const double time_before = time_;
    time_ = since_start(collision.time, clock_unit_);
    if (collision.number == 1 || collision.gap_before > threshold_) return;
    ++hits_;
    last_collision_ = collision.number - 1;
    if (hits_ > 1) return;
    first_collision_ = last_collision_;
    first_time_ = time_before;
  }

  std::int64_t hits() const { return hits_; }
  std::optional<std::int64_t> first_collision() const { return first_collision_; }
  std::optional<double> first_time() const { return first_time_; }
  std::optional<std::int64_t> last_collision() const { return last_collision_; }

 private:
  Real threshold_;
  Real clock_unit_;
  double time_ = 0;
  std::int64_t hits_ = 0;
  std::optional<std::int64_t> first_collision_;
  std::optional<double> first_time_;
  std::optional<std::int64_t> last_collision_;
};

}  // namespace zenosphere
