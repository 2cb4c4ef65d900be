#include "verify/kicks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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
  if (values.drive.kind != DriveKind::random) return;
  next_ = interval_;
  draw();
}

template <int Dim>
std::vector<Vec<Dim, long double>> Kicks<Dim>::take() {
  std::vector<Vec<Dim, long double>> changes = std::move(changes_);
  ++taken_;
  next_ = static_cast<double>(taken_ + 1) * interval_;
  draw();
  return changes;
}

template <int Dim>
void Kicks<Dim>::draw() {
  changes_.assign(spheres_, {});
  Vec<Dim, long double> mean;
  for (auto& change : changes_) {
    for (int axis = 0; axis < Dim; ++axis) change[axis] = step_ * random_.normal();
    mean += change * (1 / static_cast<long double>(spheres_));
  }
  if (keeps_momentum_) {
    for (auto& change : changes_) change -= mean;
  }
  long double square = 0;
  for (const auto& change : changes_) square = std::max(square, dot(change, change));
  largest_ = std::sqrt(square);
}

#define ZENOSPHERE_INSTANTIATE(Dim) template class Kicks<Dim>;
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere::verify
