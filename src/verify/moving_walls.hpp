#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

#include "case/case.hpp"
#include "model/grains.hpp"
#include "model/random.hpp"
#include "storage/records.hpp"
#include "verify/motion.hpp"

namespace zenosphere::verify {

/// The velocities that thermal walls have given, made again from the seed: as long as the log holds
/// every collision from the first on.
template <int Dim>
class ThermalWalls {
 public:
  using Vector = Vec<Dim, long double>;

  ThermalWalls(const Case& values, std::int64_t spheres, const Grains<double>& grains)
      : walls_(values.walls),
        grains_(grains),
        spheres_(spheres),
        random_(values.start.seed ^ stream_of_walls) {}

  /// Whether a row is of a bounce off one of them.
  bool is_thermal(const CollisionRow& row) const {
    return row.j >= spheres_ && temperature(row).has_value();
  }

  /// To be called for each row, in order: the velocity after it, or nothing where it is not known
  /// or the row is of something else.
  std::optional<Vector> observe(const CollisionRow& row) {
    is_known_ = is_known_ && row.k == ++rows_;
    if (!is_known_ || !is_thermal(row)) return std::nullopt;
    const long double speed =
        std::sqrt(static_cast<long double>(*temperature(row)) / grains_.mass(row.i));
    const int normal = static_cast<int>(*walls_.axis);
    Vector velocity;
    for (int axis = 0; axis < Dim; ++axis) {
      if (axis != normal) velocity[axis] = speed * random_.normal();
    }
    const long double fraction = 1 - random_.uniform();
    const bool is_lower = row.j == spheres_;
    velocity[normal] = (is_lower ? speed : -speed) * std::sqrt(-2 * std::log(fraction));
    velocity[0] += is_lower ? walls_.lower_speed : walls_.upper_speed;
    return velocity;
  }

 private:
  /// Part of what a seed means.
  static constexpr std::uint64_t stream_of_walls = 0x9e3779b185ebca87;

  const std::optional<double>& temperature(const CollisionRow& row) const {
    return row.j == spheres_ ? walls_.lower_temperature : walls_.upper_temperature;
  }

  Case::Walls walls_;
  Grains<double> grains_;
  std::int64_t spheres_;
  Random random_;
  std::int64_t rows_ = 0;
  bool is_known_ = true;
};

/// The lower wall of a case, which may oscillate along the axis.
class LowerWall {
 public:
  using Number = long double;

  explicit LowerWall(const Case& values)
      : motion_(values.walls.motion),
        amplitude_(in_precision(values.walls.amplitude, values.collision.precision)),
        resting_(in_precision(values.walls.resting_flight, values.collision.precision)) {
    if (!motion_) return;
    const Number frequency = in_precision(values.walls.frequency, values.collision.precision);
    const bool is_double = values.collision.precision == Precision::double_precision;
    period_ = is_double ? Number(1 / static_cast<double>(frequency)) : 1 / frequency;
    turning_ = 2 * std::numbers::pi_v<Number> / period_;
  }

  bool oscillates() const { return motion_.has_value(); }

  /// Diameters above its lowest place, and its velocity and acceleration.
  Number height(Number time) const {
    if (!motion_) return 0;
    if (is_sine()) return 2 * amplitude_ * square(std::sin(turning_ * time / 2));
    const Number from_lowest = std::abs(turns(time));
    const Number height = 16 * square(std::min(from_lowest, 0.5L - from_lowest));
    return amplitude_ * (from_lowest < 0.25L ? height : 2 - height);
  }
  Number speed(Number time) const {
    if (!motion_) return 0;
    if (is_sine()) return amplitude_ * turning_ * std::sin(turning_ * time);
    const Number from_lowest = turns(time);
    const Number size = 32 * amplitude_ / period_;
    if (std::abs(from_lowest) < 0.25L) return size * from_lowest;
    return size * (from_lowest > 0 ? 0.5L - from_lowest : -0.5L - from_lowest);
  }
  Number acceleration(Number time) const {
    if (!motion_) return 0;
    if (is_sine()) return peak_acceleration() * std::cos(turning_ * time);
    return std::abs(turns(time)) < 0.25L ? peak_acceleration() : -peak_acceleration();
  }

  Number peak_speed() const {
    if (!motion_) return 0;
    return is_sine() ? amplitude_ * turning_ : 8 * amplitude_ / period_;
  }
  Number peak_acceleration() const {
    if (!motion_) return 0;
    return is_sine() ? amplitude_ * turning_ * turning_ : 32 * amplitude_ / square(period_);
  }

  /// With which a sphere that rests is let go, where gravity pulls it with so much.
  Number resting_speed(Number time, Number pull) const {
    const Number bound = pull > peak_acceleration() ? std::sqrt(peak_acceleration() / pull) : 1;
    return (acceleration(time) + pull) * resting_ * bound * period_ / 2;
  }

 private:
  static Number square(Number number) { return number * number; }
  bool is_sine() const { return motion_ == OscillationShape::sinusoidal; }
  /// Since the wall was, or until it is, at its lowest place, in [-1/2, 1/2].
  Number turns(Number time) const { return std::remainder(time / period_, 1.0L); }

  std::optional<OscillationShape> motion_;
  Number amplitude_;
  Number resting_;
  Number period_ = 1;
  Number turning_ = 0;
};

}  // namespace zenosphere::verify
