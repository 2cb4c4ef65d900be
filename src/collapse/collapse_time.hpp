#pragma once

#include <limits>
#include <optional>

#include "model/collision.hpp"

namespace zenosphere {

/// The time at which infinitely many collisions would be over, if the flights between them shrink
/// as a geometric series.
///
/// Needs six flights in a row whose ratios agree within a thousandth, each long enough for the
/// clock to tell: a hundred thousand units in its last place. In a bouncing ball the ratio is the
/// restitution; in three balls on a line it is the eigenvalue of their map.
///
/// Source: the sum of the series, as in Bernu & Mazighi, J. Phys. A 23 (1990) 5745.
template <int Dim, class Real>
class CollapseTime {
 public:
  /// \param clock_unit  of the simulation's clock
  explicit CollapseTime(const Real& clock_unit) : clock_unit_(clock_unit) {}

  void observe(const Collision<Dim, Real>& collision) {
    const Real ratio = flight_ > 0 ? Real(collision.flight / flight_) : Real(0);
    const Real change = ratio > ratio_ ? Real(ratio - ratio_) : Real(ratio_ - ratio);
    flight_ = collision.flight;
    ratio_ = ratio;
    const Real shortest = 100000 * std::numeric_limits<Real>::epsilon() * clock_unit_;
    const bool is_alike = flight_ > shortest && ratio > 0 && ratio < 1 && change <= ratio / 1000;
    alike_ = is_alike ? alike_ + 1 : 0;
    if (alike_ < kAlike) return;
    time_ = since_start(collision.time, clock_unit_) +
            static_cast<double>(flight_ * ratio / (1 - ratio));
    shrinking_ = static_cast<double>(ratio);
  }

  /// The latest estimate, in the case's time unit, and the ratio of the flights it rests on.
  std::optional<double> time() const { return time_; }
  std::optional<double> ratio() const { return shrinking_; }

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.flight_, self.ratio_, self.alike_, self.time_, self.shrinking_);
  }

 private:
  static constexpr int kAlike = 4;  // comparisons of ratios: five ratios, six flights

  Real clock_unit_;
  Real flight_ = 0;
  Real ratio_ = 0;
  int alike_ = 0;
  std::optional<double> time_;
  std::optional<double> shrinking_;
};

}  // namespace zenosphere
