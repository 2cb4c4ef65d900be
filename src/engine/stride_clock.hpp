#pragma once

#include <algorithm>
#include <cmath>

#include "model/clock.hpp"

namespace zenosphere {

/// The clock of a simulation: where it stands, and the stride in which it counts.
///
/// Times of events are remainders: they count from the clock's whole units on, and are shifted when
/// the clock begins to count from later ones.
template <class Real>
class StrideClock {
 public:
  struct State {
    Instant<Real> now;
    double stride = 1;  ///< units: a power of two, 1 under shear
  };

  /// \param unit  length of a clock unit, in the case's time unit
  explicit StrideClock(const Real& unit) : StrideClock(unit, {}) {}
  StrideClock(const Real& unit, const State& state)
      : unit_(unit), state_(state), span_(Real(state.stride) * unit) {}

  const State& state() const { return state_; }
  const Instant<Real>& now() const { return state_.now; }
  const Real& remainder() const { return state_.now.remainder; }
  const Real& unit() const { return unit_; }
  double stride() const { return state_.stride; }
  /// The stride in time: what the remainder stays below.
  const Real& span() const { return span_; }

  Instant<Real> instant(double time) const { return instant_at(time, unit_, stride()); }
  /// Time since an earlier instant.
  Real since(const Instant<Real>& earlier) const { return elapsed(earlier, now(), unit_); }
  /// What the remainder was at an earlier instant, counted from the whole units of now.
  Real remainder_at(const Instant<Real>& earlier) const {
    return earlier.remainder +
           (static_cast<Real>(earlier.units) - static_cast<Real>(now().units)) * unit_;
  }

  /// Not at the start any more.
  bool has_begun() const { return now().units > 0 || remainder() > 0; }
  /// Whether it stands at `time` since the start, or later.
  bool has_reached(double time) const {
    const Instant<Real> wanted = instant(time);
    return now().units > wanted.units ||
           (now().units == wanted.units && remainder() >= wanted.remainder);
  }
  /// Strides up to the remainder `next`: whole ones, in units.
  Real units_to(const Real& next) const {
    using std::floor;
    return floor(static_cast<Real>(next / span_)) * Real(stride());
  }

  /// Goes on to a remainder; where that is slightly in the past by rounding it stays.
  void advance_to(const Real& remainder) {
    state_.now.remainder = std::max(state_.now.remainder, remainder);
  }
  /// Is set to a remainder, also to one in the past: a collision may lie there.
  void set_to(const Real& remainder) { state_.now.remainder = remainder; }

  /// Counts from so many units later on. Returns the time by which all remainders become less.
  Real shift(double units) {
    const Real span = Real(units) * unit_;
    state_.now.units += units;
    state_.now.remainder = std::max(Real(0), Real(state_.now.remainder - span));
    return span;
  }
  /// Counts in strides of so many units from now on. Its units may then be no whole number of them.
  void use_stride(double stride) {
    state_.stride = stride;
    span_ = Real(stride) * unit_;
  }

 private:
  Real unit_;
  State state_;
  Real span_;
};

}  // namespace zenosphere
