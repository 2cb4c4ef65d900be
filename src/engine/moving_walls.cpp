#include "engine/moving_walls.hpp"

#include <cmath>

#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

/// Any odd constant makes a stream apart from the others of a seed; this one is that of xxHash.
constexpr std::uint64_t wall_stream = 0x9e3779b185ebca87;

}  // namespace

template <int Dim, class Real>
MovingWalls<Dim, Real>::MovingWalls(const Walls<Real>& walls, std::int32_t spheres,
                                    const Real& clock_unit)
    : clock_unit_(clock_unit), random_(walls.seed ^ wall_stream) {
  if (!walls.oscillation) return;
  period_ = walls.oscillation->period();
  departures_.resize(static_cast<std::size_t>(spheres));
}

template <int Dim, class Real>
void MovingWalls<Dim, Real>::forget_departures() {
  for (Departure& departure : departures_) departure.collisions = 0;
}

template <int Dim, class Real>
Real MovingWalls<Dim, Real>::phase(const Instant<Real>& when) const {
  const Real whole = static_cast<Real>(when.units) * clock_unit_;
  Real phase = after_whole_periods(whole, period_) + when.remainder;
  if (phase < 0) phase = period_ - after_whole_periods(Real(-phase), period_);  // slightly past
  return after_whole_periods(phase, period_);
}

template <int Dim, class Real>
Vec<Dim, Real> MovingWalls<Dim, Real>::thermal_velocity(const Walls<Real>& walls, int side,
                                                        const Real& mass) {
  using std::sqrt;
  const auto at = static_cast<std::size_t>(side);
  const Real speed = sqrt(static_cast<Real>(*walls.temperature[at] / mass));
  Vector velocity;
  for (int axis = 0; axis < Dim; ++axis) {
    if (axis != walls.axis) velocity[axis] = speed * Real(random_.normal());
  }
  const double fraction = 1 - random_.uniform();  // in (0, 1]
  const double along = std::sqrt(-2 * portable_log(fraction));
  velocity[walls.axis] = (side == 0 ? speed : Real(-speed)) * Real(along);
  if (walls.axis != 0) velocity[0] += walls.speed[at];
  return velocity;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class MovingWalls<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
