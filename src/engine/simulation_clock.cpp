// The clock of a simulation: how it is set back, and in which strides it counts.

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/simulation.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

/// Sets the clock and all times back by whole strides, or gives it longer strides; under shear by
/// one unit, and the layers slide by a cell.
template <int Dim, class Real>
void Simulation<Dim, Real>::rebase(const Real& next_event, const Instant<Real>& limit) {
  using std::floor;
  if (box().is_sheared()) return set_back(1);
  if (widen_stride(next_event)) return;
  // Nothing happens until the next event: go there at once.
  const double left = limit.units - now_.units;
  const Real whole = floor(static_cast<Real>(next_event / span_)) * Real(stride_);
  set_back(whole < static_cast<Real>(left) ? static_cast<double>(whole) : left);
}

template <int Dim, class Real>
void Simulation<Dim, Real>::set_back(double units) {
  const Real span = Real(units) * box().clock_unit();
  now_.units += units;
  now_.remainder = std::max(Real(0), Real(now_.remainder - span));
  spheres_.set_back(span);
  rewind_bound_.set_back(span);
  for (NextMeetings<Real>& next : meetings_) next.set_back(span);
  calendar_.set_back(span);
  if (!spheres_.slide_near()) return;
  for (std::int32_t i = 0; i < spheres(); ++i) predict_new(i, spheres_.slid_near(i));
}

/// Lengthens the strides of a clock without shear where it would have to be set back for nearly
/// every event, or where the counter would lose units. Returns whether it has.
///
/// A stride is then as long as the fastest sphere takes for a diameter, or half as long: as in a
/// gas of granular temperature 1. Only where no sphere ever becomes faster again.
///
/// \param leap  time until the next event
template <int Dim, class Real>
bool Simulation<Dim, Real>::widen_stride(const Real& leap) {
  constexpr double worth_it = 65536;  // spheres that are set back, for one event
  const Real units = leap / box().clock_unit();
  double stride = least_stride(now_.units + static_cast<double>(units));
  if (only_cools() && units * spheres() >= Real(worth_it) * Real(stride_)) {
    Real square = 0;
    for (std::int32_t i = 0; i < spheres(); ++i) {
      square = std::max(square, dot(spheres_[i].velocity, spheres_[i].velocity));
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
  const bool is_pulled = !(spheres_.acceleration() == Vector{});
  const auto& walls = surroundings_.walls;
  return !is_pulled && (!walls || !walls->feed_energy());
}

/// Lets the clock count in strides of so many units, if that is more. Returns whether it is.
template <int Dim, class Real>
bool Simulation<Dim, Real>::lengthen_stride(double stride) {
  if (stride <= stride_) return false;
  stride_ = stride;
  span_ = Real(stride) * box().clock_unit();
  const double odd = std::fmod(now_.units, stride);
  const Real remainder = now_.remainder;
  if (odd > 0) {
    set_back(-odd);
    now_.remainder = remainder + Real(odd) * box().clock_unit();
  }
  return true;
}

/// Lets the clock count in the shortest strides again, before spheres become faster.
template <int Dim, class Real>
void Simulation<Dim, Real>::shorten_stride() {
  using std::floor;
  const double least = least_stride(now_.units);
  if (!(least < stride_)) return;
  stride_ = least;
  span_ = Real(least) * box().clock_unit();
  if (now_.remainder >= span_) {
    set_back(static_cast<double>(floor(static_cast<Real>(now_.remainder / span_))) * least);
  }
}

template <int Dim, class Real>
void Simulation<Dim, Real>::wait_until(double time) {
  Instant<Real> wanted = instant(time);
  if (!box().is_sheared() && wanted.units > now_.units) {
    if (lengthen_stride(least_stride(wanted.units))) wanted = instant(time);
    if (wanted.units > now_.units) set_back(wanted.units - now_.units);
  }
  if (now_.units == wanted.units) now_.remainder = std::max(now_.remainder, wanted.remainder);
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                         \
  template void Simulation<Dim, Real>::rebase(const Real&, const Instant<Real>&); \
  template void Simulation<Dim, Real>::shorten_stride();                          \
  template void Simulation<Dim, Real>::wait_until(double);
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
