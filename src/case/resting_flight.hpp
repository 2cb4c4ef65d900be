#pragma once

#include <cmath>

namespace zenosphere {

/// How long a sphere flies that rests on the oscillating wall: a part of the period, and of the
/// time in which gravity reverses the speed of the wall where the wall alone takes longer.
///
/// A period that is long beside sqrt(amplitude / gravity) says nothing about how a ball bounces: a
/// part of it would be a flight higher than the amplitude. So bounded, no hop is higher than
/// pi^2 resting_flight^2 amplitudes.
///
/// \param part     walls.resting_flight, periods
/// \param period   of the wall
/// \param peak     acceleration of the wall, diameters/time^2
/// \param gravity  towards the wall, diameters/time^2; may be negative
/// \return         time
template <class Real>
Real longest_resting_flight(const Real& part, const Real& period, const Real& peak,
                            const Real& gravity) {
  using std::sqrt;
  const Real flight = part * period;
  return gravity > peak ? Real(flight * sqrt(static_cast<Real>(peak / gravity))) : flight;
}

}  // namespace zenosphere
