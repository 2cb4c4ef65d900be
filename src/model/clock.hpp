#pragma once

#include <cmath>
#include <cstdint>

#include "model/archive.hpp"

namespace zenosphere {

/// The end of the clock [units]; with what is added in one step it fits 64 bits.
inline constexpr std::int64_t most_units = 9'000'000'000'000'000'000;

/// An instant as whole clock units and a remainder, so that its resolution does not decay with
/// the length of a run.
///
/// Under shear one unit is the time in which adjacent layers slide by one cell. The remainder
/// lies in [0, unit) up to the rounding of an event that is done slightly in the past.
template <class Real>
struct Instant {
  std::int64_t units = 0;
  Real remainder = 0;  ///< in the case's time unit

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.units, self.remainder);
    using std::isfinite;
    require_archived(self.units >= 0 && self.units <= most_units && isfinite(self.remainder),
                     "a time that there is not");
  }
};

/// Time from `earlier` to `later`; zero if and only if the clock did not move.
///
/// \param unit  length of a clock unit, in the case's time unit
template <class Real>
Real elapsed(const Instant<Real>& earlier, const Instant<Real>& later, const Real& unit) {
  return static_cast<Real>(later.units - earlier.units) * unit +
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

/// The instant at a time since the start. Times beyond the reach of the counter, and what is no
/// number, become its end; times before the start one unit before it.
template <class Real>
Instant<Real> instant_at(double time, const Real& unit) {
  using std::floor;
  const Real units = floor(static_cast<Real>(Real(time) / unit));
  if (!(units <= Real(static_cast<double>(most_units)))) return {most_units, 0};
  if (units < 0) return {-1, 0};
  return {static_cast<std::int64_t>(units), Real(time) - units * unit};
}

}  // namespace zenosphere
