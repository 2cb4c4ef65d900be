#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "model/archive.hpp"

namespace zenosphere {

/// The largest number of clock units.
inline constexpr double most_units = std::numeric_limits<double>::max();

/// An instant as whole clock units and a remainder, so that its resolution does not decay with
/// the length of a run.
///
/// Under shear one unit is the time in which adjacent layers slide by one cell, and the remainder
/// lies in [0, unit) up to the rounding of an event that is done slightly in the past. Without
/// shear the clock counts in strides of 1, 2, 4, ... units, which grow as a gas cools; then the
/// remainder lies in [0, stride).
template <class Real>
struct Instant {
  double units = 0;    ///< a whole number, and of strides too
  Real remainder = 0;  ///< in the case's time unit

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.units, self.remainder);
    using std::isfinite;
    require_archived(self.units >= 0 && self.units <= most_units &&
                         std::floor(self.units) == self.units && isfinite(self.remainder),
                     "a time that there is not");
  }
};

/// The last moment of the clock, in the case's time unit: the largest `double`. In `double` itself
/// it is the time in which a sphere flies a diameter whose speed has a square that all digits fit.
template <class Real>
constexpr double end_of_clock() {
  constexpr double slowest_in_double = 0x1p-500;
  return std::is_same_v<Real, double> ? 1 / slowest_in_double : std::numeric_limits<double>::max();
}

/// The least stride, a power of two, in which a counter of 53 bits gets to `units` exactly.
inline double least_stride(double units) {
  constexpr int digits = std::numeric_limits<double>::digits - 1;
  return std::max(1.0, std::ldexp(1.0, std::ilogb(std::max(units, 1.0)) - digits + 1));
}

/// Time from `earlier` to `later`; zero if and only if the clock did not move.
///
/// \param unit  length of a clock unit, in the case's time unit
template <class Real>
Real elapsed(const Instant<Real>& earlier, const Instant<Real>& later, const Real& unit) {
  return (static_cast<Real>(later.units) - static_cast<Real>(earlier.units)) * unit +
         (later.remainder - earlier.remainder);
}

/// The instant as one number since the start, in the case's time unit and all digits of Real.
template <class Real>
Real exactly_since_start(const Instant<Real>& instant, const Real& unit) {
  return static_cast<Real>(instant.units) * unit + instant.remainder;
}
template <class Real>
double since_start(const Instant<Real>& instant, const Real& unit) {
  return static_cast<double>(exactly_since_start(instant, unit));
}

/// The instant at a time since the start, as a clock has it that counts in strides of so many
/// units. Times beyond the reach of the counter, and what is no number, become its end; times
/// before the start one unit before it.
template <class Real>
Instant<Real> instant_at(double time, const Real& unit, double stride = 1) {
  using std::floor;
  const Real span = unit * Real(stride);
  const Real strides = floor(static_cast<Real>(Real(time) / span));
  if (!(strides * Real(stride) <= Real(most_units))) return {most_units, 0};
  if (strides < 0) return {-1, 0};
  return {static_cast<double>(strides) * stride, Real(time) - strides * span};
}

}  // namespace zenosphere
