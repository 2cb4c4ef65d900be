#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "model/elementary.hpp"

namespace zenosphere {

/// How a wall oscillates: as a sine, or with an acceleration of constant size that changes sign.
enum class OscillationShape { sinusoidal, parabolic };

/// Pi in all digits of Real, from sums and quotients only: the same on every machine.
/// Source: pi = 16 arctan(1/5) - 4 arctan(1/239), Machin (1706).
template <class Real>
Real pi() {
  const auto arctangent_of_inverse = [](int x) {
    Real power = Real(1) / Real(x);
    Real sum = power;
    for (int n = 3;; n += 2) {
      power /= Real(-x * x);
      const Real next = sum + power / Real(n);
      if (next == sum) return sum;
      sum = next;
    }
  };
  return Real(16) * arctangent_of_inverse(5) - Real(4) * arctangent_of_inverse(239);
}

/// The remainder of x >= 0 after whole periods, without rounding: each difference is exact
/// (Sterbenz).
template <class Real>
Real after_whole_periods(Real x, const Real& period) {
  Real multiple = period;
  while (multiple + multiple <= x) multiple += multiple;
  for (; multiple >= period; multiple *= Real(0.5)) {
    if (x >= multiple) x -= multiple;
  }
  return x;
}

/// The motion of a wall along its normal: from its lowest place, where it rests at time 0, up to
/// twice its amplitude and back.
///
/// Sinusoidal: amplitude (1 - cos(2 pi t / period)). Parabolic: accelerated upwards at
/// 32 amplitude / period^2 in the first and the last quarter of a period, downwards in between.
template <class Real>
class Oscillation {
 public:
  /// Where the wall is, diameters above its lowest place, and the two derivatives.
  struct State {
    Real height;
    Real speed;
    Real acceleration;
  };
  /// What remains of a way where a motion at constant speed has been taken off.
  struct Deviation {
    Real height;
    Real speed;
  };
  /// A moment of the motion from which deviations are counted.
  struct Origin {
    Real phase;
    SineAndCosine<Real> turned;  ///< of its angle, where the motion is a sine
  };

  /// \param amplitude  > 0, diameters
  /// \param period     > 0, time
  Oscillation(OscillationShape shape, const Real& amplitude, const Real& period)
      : shape_(shape),
        amplitude_(amplitude),
        period_(period),
        whole_turn_(2 * pi<Real>()),
        turning_(whole_turn_ / period),
        steady_(32 * amplitude / (period * period)) {}

  OscillationShape shape() const { return shape_; }
  const Real& amplitude() const { return amplitude_; }
  const Real& period() const { return period_; }

  /// The largest of its acceleration, and of how fast that changes where it changes continuously.
  Real peak_acceleration() const {
    return is_sine() ? Real(amplitude_ * turning_ * turning_) : steady_;
  }
  Real peak_jerk() const { return amplitude_ * turning_ * turning_ * turning_; }

  /// \param phase  time since the wall was at its lowest place, in [0, period)
  State at(const Real& phase) const {
    if (is_sine()) {
      const auto [sine, cosine] = turned_by(phase);
      return {amplitude_ * (1 - cosine), amplitude_ * turning_ * sine,
              amplitude_ * turning_ * turning_ * cosine};
    }
    const auto [height, speed] = pushed(Real(0), phase);
    return {height, speed, acceleration_in(piece(phase))};
  }

  Origin origin(const Real& phase) const {
    return {phase, is_sine() ? turned_by(phase) : SineAndCosine<Real>{0, 1}};
  }

  /// How much the wall is off, `span` later, a motion at its speed at the origin, and how it is
  /// accelerated then. No digits are lost where the span is short.
  struct Later {
    Deviation deviation;
    Real acceleration;
  };
  Later later(const Origin& origin, const Real& span) const {
    if (is_sine()) return later_on_sine(origin.turned, span);
    return {parabolic_deviation(origin.phase, span),
            acceleration_in(piece(phase_after(origin.phase, span)))};
  }

  /// The phase after some time.
  Real phase_after(const Real& phase, const Real& span) const {
    const Real then = phase + span;
    if (!(then < 0)) return after_whole_periods(then, period_);
    const Real before = period_ - after_whole_periods(Real(-then), period_);
    return before < period_ ? before : Real(0);
  }

  /// Of a parabolic motion: the piece of constant acceleration in which a phase lies, 0 to 2, where
  /// it ends, and how the wall is accelerated there.
  int piece(const Real& phase) const {
    return 4 * phase < period_ ? 0 : 4 * phase < 3 * period_ ? 1 : 2;
  }
  Real end_of(int piece) const {
    return piece == 0 ? Real(period_ / 4) : piece == 1 ? Real(3 * period_ / 4) : period_;
  }
  Real acceleration_in(int piece) const { return piece == 1 ? Real(-steady_) : steady_; }

 private:
  bool is_sine() const { return shape_ == OscillationShape::sinusoidal; }

  /// Sine and cosine of the angle that belongs to a time.
  SineAndCosine<Real> turned_by(const Real& time) const {
    using std::floor;
    Real turns = time / period_;
    turns -= floor(static_cast<Real>(turns + Real(0.5)));
    const Real quarters = floor(static_cast<Real>(4 * turns + Real(0.5)));
    const auto [sine, cosine] = sine_and_cosine(Real(whole_turn_ * (turns - quarters / 4)));
    if (quarters == 0) return {sine, cosine};
    if (quarters == 1) return {cosine, -sine};
    if (quarters == -1) return {-cosine, sine};
    return {-sine, -cosine};
  }

  /// With x the angle at the origin and y that of the span: the height above the tangent is
  /// cos x (1 - cos y) - sin x (y - sin y).
  Later later_on_sine(const SineAndCosine<Real>& origin, const Real& span) const {
    const auto& [sine, cosine] = origin;
    const Real angle = turning_ * span;
    const auto [versine, lag, turn] = small_parts(angle, span);
    const Real speed = amplitude_ * turning_;
    return {
        {amplitude_ * (cosine * versine - sine * lag), speed * (cosine * turn - sine * versine)},
        speed * turning_ * (cosine - (cosine * versine + sine * turn))};
  }

  struct SmallParts {
    Real versine;  ///< 1 - cos
    Real lag;      ///< angle - sin
    Real sine;
  };
  SmallParts small_parts(const Real& angle, const Real& span) const {
    if (angle > 1 || angle < -1) {
      const auto [sine, cosine] = turned_by(span);
      return {1 - cosine, angle - sine, sine};
    }
    SmallParts parts{0, 0, angle};
    Real term = -angle;  // - angle^n / n!, with the sign of the series
    for (int n = 2;; n += 2) {
      term *= -angle / n;
      const Real versine = parts.versine + term;
      term *= angle / (n + 1);
      const Real lag = parts.lag + term;
      if (versine == parts.versine && lag == parts.lag) break;
      parts.versine = versine;
      parts.lag = lag;
    }
    parts.sine = angle - parts.lag;
    return parts;
  }

  /// A whole number of periods later the wall is where it was, with the speed that it had.
  Deviation parabolic_deviation(const Real& phase, const Real& span) const {
    using std::floor;
    const Real periods = floor(static_cast<Real>(span / period_));
    const Real rest = span - periods * period_;
    Deviation deviation = pushed(phase, rest);
    if (periods != 0) deviation.height -= at(phase).speed * (periods * period_);
    return deviation;
  }

  /// What the acceleration does in less than two periods from a phase on.
  Deviation pushed(const Real& phase, const Real& span) const {
    Deviation gained{0, 0};
    Real here = phase;
    Real left = span;
    for (int piece = this->piece(phase); left > 0; piece = (piece + 1) % 3) {
      const Real room = end_of(piece) - here;
      const Real time = left < room ? left : room;
      const Real acceleration = acceleration_in(piece);
      gained.height += gained.speed * time + acceleration * time * time / 2;
      gained.speed += acceleration * time;
      left -= time;
      here = piece == 2 ? Real(0) : end_of(piece);
    }
    return gained;
  }

  OscillationShape shape_;
  Real amplitude_;
  Real period_;
  Real whole_turn_;  ///< 2 pi
  Real turning_;     ///< 2 pi / period
  Real steady_;      ///< size of a parabolic acceleration
};

}  // namespace zenosphere
