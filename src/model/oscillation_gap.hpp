#pragma once

#include <algorithm>
#include <optional>

#include "model/oscillation.hpp"
#include "model/walls.hpp"

namespace zenosphere {

/// The gap between a sphere that flies or falls and an oscillating wall below it, and when it
/// closes.
///
/// Everything is relative to the wall and counted from one moment at which gap and rate are known:
/// a flight that begins on the wall keeps its digits, however low it is.
template <class Real>
class OscillationGap {
 public:
  struct State {
    Real gap;           ///< surface distance, diameters
    Real rate;          ///< at which it grows, diameters/time
    Real acceleration;  ///< of it
  };
  /// When something has to be done, counted from the moment at which the gap is known.
  struct Due {
    Real span;
    bool is_contact;  ///< otherwise nothing has come of it up to there: to be looked at again
  };

  /// \param phase  of the wall at that moment, in [0, period)
  /// \param gap, rate  at that moment
  /// \param acceleration  of the sphere along the axis
  OscillationGap(const Oscillation<Real>& oscillation, const Real& phase, const Real& gap,
                 const Real& rate, const Real& acceleration)
      : oscillation_(oscillation),
        origin_(oscillation.origin(phase)),
        gap_(gap),
        rate_(rate),
        acceleration_(acceleration) {}

  State at(const Real& span) const {
    const auto [deviation, pushed] = oscillation_.later(origin_, span);
    return {gap_ + rate_ * span + acceleration_ * span * span / 2 - deviation.height,
            rate_ + acceleration_ * span - deviation.speed, acceleration_ - pushed};
  }

  /// How far the sphere is then above the highest place of the wall, diameters.
  Real clearance(const Real& span) const { return clearance(at(span), span); }

  /// When the gap closes first, from `from` on: where the sphere stays for so long where the wall
  /// comes. Otherwise a moment up to which it certainly does not.
  ///
  /// Bracketing from below: over the next step the gap is at least that of a parabola with the
  /// least acceleration there can be, so that a step to where this closes passes no contact; near a
  /// contact steps converge quadratically. Where the wall is drawn away, the step is one for which
  /// the change of its acceleration (peak jerk) certainly leaves a gap. The roots of a parabolic
  /// motion are exact.
  ///
  /// Source: a bound on a derivative in place of small steps, Piyavskii, USSR Comput. Math. Math.
  /// Phys. 12 (1972) 57; Shubert, SIAM J. Numer. Anal. 9 (1972) 379; with second derivatives
  /// Breiman & Cutler, Math. Program. 58 (1993) 179.
  Due due(const Real& from) const {
    return oscillation_.shape() == OscillationShape::sinusoidal ? sine_due(from)
                                                                : parabolic_due(from);
  }

  /// A sphere so far above the highest place of the wall is out of its reach for now.
  static Real out_of_reach(const Oscillation<Real>& oscillation) {
    return oscillation.amplitude() / 4;
  }

 private:
  Real phase_at(const Real& span) const { return oscillation_.phase_after(origin_.phase, span); }
  Real clearance(const State& state, const Real& span) const {
    const auto wall = oscillation_.at(phase_at(span));
    return state.gap + (wall.height - 2 * oscillation_.amplitude());
  }
  /// Surely so, also for who looks with other roundings.
  bool has_left(const State& state, const Real& span) const {
    const Real far = out_of_reach(oscillation_) * Real(1.0625);
    return state.gap > far && clearance(state, span) > far;
  }

  /// Whether a sphere that touches the wall is not let go.
  static bool is_due_now(const State& state) {
    if (state.gap > 0) return false;
    return state.rate < 0 || (!(state.rate > 0) && !(state.acceleration > 0));
  }

  Due sine_due(const Real& from) const {
    const Real least = acceleration_ - oscillation_.peak_acceleration();
    const Real end = from + oscillation_.period();
    Real span = from;
    for (bool is_first = true;; is_first = false) {
      State state = at(span);
      // Later a gap of 0 by rounding is the contact; at first the sphere may leave the wall.
      if (is_due_now(state) || (!is_first && !(state.gap > 0) && !(state.rate > 0))) {
        return {span, true};
      }
      if (span >= end || (!is_first && has_left(state, span))) return {span, false};
      const Real next = span + safe_step(state, least);
      if (!(next > span)) return {span, true};
      span = std::min(next, end);
    }
  }

  /// A time for which the gap stays open.
  Real safe_step(State state, const Real& least) const {
    state.gap = std::max(state.gap, Real(0));
    Real step = 0;
    if (least < 0) {
      step = *closing_time(state.gap, state.rate, least);
    } else {
      step = closing_time(state.gap, state.rate, least).value_or(oscillation_.period());
    }
    if (!(state.rate < 0) && state.acceleration > 0) {
      step = std::max(step, Real(3 * state.acceleration / oscillation_.peak_jerk()));
    }
    return step;
  }

  Due parabolic_due(const Real& from) const {
    const Real end = from + oscillation_.period();
    Real phase = phase_at(from);
    State state = at(from);
    Real span = from;
    for (int piece = oscillation_.piece(phase); span < end; piece = (piece + 1) % 3) {
      state.acceleration = acceleration_ - oscillation_.acceleration_in(piece);
      if (is_due_now(state)) return {span, true};
      const Real room = oscillation_.end_of(piece) - phase;
      const auto closes =
          closing_time(std::max(state.gap, Real(0)), state.rate, state.acceleration);
      if (closes && *closes <= room) return {span + *closes, true};
      state.gap += state.rate * room + state.acceleration * room * room / 2;
      state.rate += state.acceleration * room;
      span += room;
      phase = piece == 2 ? Real(0) : oscillation_.end_of(piece);
      if (has_left(state, span)) break;
    }
    return {span, false};
  }

  const Oscillation<Real>& oscillation_;
  typename Oscillation<Real>::Origin origin_;
  Real gap_;
  Real rate_;
  Real acceleration_;
};

}  // namespace zenosphere
