#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "model/collision.hpp"

namespace zenosphere {

/// The time at which infinitely many collisions would be over, if the flights between them shrink
/// as a geometric series.
///
/// Needs six flights in a row whose ratios agree within a thousandth, each long enough for the
/// clock to tell: a hundred thousand units in its last place, which is that of a clock unit, or of
/// the remainder where the clock counts in longer strides. In a bouncing ball the ratio is the
/// restitution; in three balls on a line it is the eigenvalue of their map.
///
/// Source: the sum of the series, as in Bernu & Mazighi, J. Phys. A 23 (1990) 5745.
template <int Dim, class Real>
class CollapseTime {
 public:
  /// \param clock_unit  of the simulation's clock
  explicit CollapseTime(const Real& clock_unit) : clock_unit_(clock_unit) {}

  void observe(const Collision<Dim, Real>& collision) {
    using std::abs;
    const Real ratio = flight_ > 0 ? Real(collision.flight / flight_) : Real(0);
    const Real change = abs(Real(ratio - ratio_));
    flight_ = collision.flight;
    ratio_ = ratio;
    const Real place = std::max(clock_unit_, Real(abs(collision.time.remainder)));
    const Real shortest = 100000 * std::numeric_limits<Real>::epsilon() * place;
    // First what seldom holds: the others do for every second flight, which no processor foresees.
    const bool is_alike = change <= ratio / 1000 && flight_ > shortest && ratio > 0 && ratio < 1;
    alike_ = is_alike ? alike_ + 1 : 0;
    if (alike_ < least_alike) return;
    // At the end of a series rounding eats into the flights: what they told before was better.
    const Real error = flight_ * (change + std::numeric_limits<Real>::epsilon());
    if (alike_ > least_alike && error > error_) return;
    error_ = error;
    time_ = exactly_since_start(collision.time, clock_unit_) + flight_ * ratio / (1 - ratio);
    shrinking_ = ratio;
  }

  /// The best estimate of the latest series, in the case's time unit, and the ratio of the flights
  /// it rests on.
  const std::optional<Real>& time() const { return time_; }
  const std::optional<Real>& ratio() const { return shrinking_; }

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.flight_, self.ratio_, self.alike_, self.error_, self.time_, self.shrinking_);
    require_archived(self.alike_ >= 0 && self.alike_ <= most_alike, "a count that there is not");
  }

 private:
  static constexpr int most_alike = 1 << 30;  // a geometric series leaves double sooner
  static constexpr int least_alike = 4;       // comparisons of ratios: five ratios, six flights

  Real clock_unit_;
  Real flight_ = 0;
  Real ratio_ = 0;
  int alike_ = 0;
  Real error_ = 0;  ///< of the estimate, by how much the ratios differ
  std::optional<Real> time_;
  std::optional<Real> shrinking_;
};

}  // namespace zenosphere
