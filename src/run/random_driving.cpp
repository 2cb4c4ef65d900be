#include "run/random_driving.hpp"

#include <cmath>

#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

/// Any odd constant makes a stream apart from the one of the start; this is the golden ratio's.
constexpr std::uint64_t other_stream = 0x9e3779b97f4a7c15;

/// The change that all together get: by mass, and of mobile spheres.
template <int Dim, class Real>
Vec<Dim, Real> mean_of(const std::vector<Vec<Dim, Real>>& changes, const Grains<Real>& grains) {
  Vec<Dim, Real> mean;
  if (grains.are_alike()) {
    for (const auto& change : changes) {
      mean += change * Real(1 / Real(static_cast<double>(changes.size())));
    }
    return mean;
  }
  Real mass = 0;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(changes.size()); ++i) {
    if (grains.is_immobile(i)) continue;
    mean += changes[static_cast<std::size_t>(i)] * grains.mass(i);
    mass += grains.mass(i);
  }
  return mean * Real(1 / mass);
}

}  // namespace

template <int Dim, class Real>
RandomDriving<Dim, Real>::RandomDriving(const Case& values)
    : random_(values.start.seed ^ other_stream),
      interval_(values.drive.kick_interval),
      step_(std::sqrt(values.drive.noise_strength * values.drive.kick_interval)),
      keeps_momentum_(!values.walls.axis) {
  if (values.drive.kind == DriveKind::random) next_kick_ = interval_;
}

template <int Dim, class Real>
void RandomDriving<Dim, Real>::kick(Simulation<Dim, Real>& simulation,
                                    Measurements<Dim, Real>& measurements) {
  std::vector<Vec<Dim, Real>> changes(static_cast<std::size_t>(simulation.spheres()));
  for (auto& change : changes) {
    for (int axis = 0; axis < Dim; ++axis) change[axis] = Real(step_ * random_.normal());
  }
  if (keeps_momentum_) {
    const Vec<Dim, Real> mean = mean_of(changes, simulation.grains());
    for (auto& change : changes) change -= mean;
  }
  measurements.kick(simulation, changes);
  ++kicks_;
  schedule();
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class RandomDriving<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
