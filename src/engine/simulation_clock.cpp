// The clock of a simulation: how times are shifted, and in which strides it counts.

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/simulation.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

/// Shifts the clock and all times by whole strides, or gives it longer strides; under shear by
/// one unit, and the layers slide by a cell.
template <int Dim, class Real>
void Simulation<Dim, Real>::rebase(const Real& next_event, const Instant<Real>& limit) {
  if (box().is_sheared()) return shift_times(1);
  if (widen_stride(next_event)) return;
  // Nothing happens until the next event: go there at once.
  const double left = limit.units - now().units;
  const Real whole = clock().units_to(next_event);
  shift_times(whole < static_cast<Real>(left) ? static_cast<double>(whole) : left);
}

template <int Dim, class Real>
void Simulation<Dim, Real>::shift_times(double units) {
  const Real span = system_.clock.shift(units);
  system_.spheres.shift_times(span);
  system_.search.shift_times(system_.spheres, span);
  predictor_.shift_times(span);
  if (!system_.search.slide_near(system_.spheres)) return;
  for (std::int32_t i = 0; i < spheres(); ++i) {
    predictor_.add_meetings(system_, i, system_.search.slid_near(system_.spheres, i));
  }
}

/// Lengthens the strides of a clock without shear where times would have to be shifted for nearly
/// every event, or where the counter would lose units. Returns whether it has.
///
/// A stride is then as long as the fastest sphere takes for a diameter, or half as long: as in a
/// gas of granular temperature 1. Only where no sphere ever becomes faster again.
///
/// \param leap  time until the next event
template <int Dim, class Real>
bool Simulation<Dim, Real>::widen_stride(const Real& leap) {
  constexpr double worth_it = 65536;  // spheres whose times are shifted, for one event
  const Real units = leap / box().clock_unit();
  double stride = least_stride(now().units + static_cast<double>(units));
  if (only_cools() && units * spheres() >= Real(worth_it) * Real(clock().stride())) {
    Real square = 0;
    for (std::int32_t i = 0; i < spheres(); ++i) {
      const Vector& velocity = system_.spheres[i].velocity;
      square = std::max(square, dot(velocity, velocity));
    }
    const double fitting = 1 / std::sqrt(static_cast<double>(square));
    if (std::isfinite(fitting)) stride = std::max(stride, std::ldexp(1.0, std::ilogb(fitting)));
  }
  return lengthen_stride(stride);
}

/// Whether energy is only lost: nothing pulls the spheres, and no wall drags them along or pushes
/// them.
template <int Dim, class Real>
bool Simulation<Dim, Real>::only_cools() const {
  const bool is_pulled = !(system_.spheres.acceleration() == Vector{});
  const auto& walls = surroundings().walls;
  return !is_pulled && (!walls || !walls->feed_energy());
}

/// Lets the clock count in strides of so many units, if that is more. Returns whether it is.
template <int Dim, class Real>
bool Simulation<Dim, Real>::lengthen_stride(double stride) {
  if (stride <= clock().stride()) return false;
  system_.clock.use_stride(stride);
  const double odd = std::fmod(now().units, stride);
  const Real remainder = clock().remainder();
  if (odd > 0) {
    shift_times(-odd);
    system_.clock.set_to(remainder + Real(odd) * clock().unit());
  }
  return true;
}

/// Lets the clock count in the shortest strides again, before spheres become faster.
template <int Dim, class Real>
void Simulation<Dim, Real>::shorten_stride() {
  using std::floor;
  const double least = least_stride(now().units);
  if (!(least < clock().stride())) return;
  system_.clock.use_stride(least);
  if (clock().remainder() >= clock().span()) {
    const Real strides = floor(static_cast<Real>(clock().remainder() / clock().span()));
    shift_times(static_cast<double>(strides) * least);
  }
}

template <int Dim, class Real>
void Simulation<Dim, Real>::wait_until(double time) {
  Instant<Real> wanted = clock().instant(time);
  if (!box().is_sheared() && wanted.units > now().units) {
    if (lengthen_stride(least_stride(wanted.units))) wanted = clock().instant(time);
    if (wanted.units > now().units) shift_times(wanted.units - now().units);
  }
  if (now().units == wanted.units) system_.clock.advance_to(wanted.remainder);
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                         \
  template void Simulation<Dim, Real>::rebase(const Real&, const Instant<Real>&); \
  template void Simulation<Dim, Real>::shorten_stride();                          \
  template void Simulation<Dim, Real>::wait_until(double);
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
