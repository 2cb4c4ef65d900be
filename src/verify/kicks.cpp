#include "verify/kicks.hpp"

#include <cmath>

#include "model/instantiate.hpp"

namespace zenosphere::verify {
namespace {

/// Keeps the kicks' random numbers apart from those of the start; part of what a seed means.
constexpr std::uint64_t stream_of_kicks = 0x9e3779b97f4a7c15;

}  // namespace

template <int Dim>
Kicks<Dim>::Kicks(const Case& values, std::int64_t spheres)
    : random_(values.start.seed ^ stream_of_kicks),
      spheres_(static_cast<std::size_t>(spheres)),
      interval_(values.drive.kick_interval),
      step_(std::sqrt(values.drive.noise_strength * values.drive.kick_interval)),
      keeps_momentum_(!values.walls.axis) {
  if (values.drive.kind == DriveKind::random) next_ = interval_;
}

template <int Dim>
std::vector<Vec<Dim, long double>> Kicks<Dim>::take() {
  std::vector<Vec<Dim, long double>> changes(spheres_);
  Vec<Dim, long double> mean;
  for (auto& change : changes) {
    for (int axis = 0; axis < Dim; ++axis) change[axis] = step_ * random_.normal();
    mean += change * (1 / static_cast<long double>(spheres_));
  }
  if (keeps_momentum_) {
    for (auto& change : changes) change -= mean;
  }
  ++taken_;
  next_ = static_cast<double>(taken_ + 1) * interval_;
  return changes;
}

#define ZENOSPHERE_INSTANTIATE(Dim) template class Kicks<Dim>;
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere::verify
