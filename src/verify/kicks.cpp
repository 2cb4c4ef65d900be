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
Kicks<Dim>::Kicks(const Case& values, std::int64_t spheres, const Grains<double>& grains)
    : grains_(grains),
      random_(values.start.seed ^ stream_of_kicks),
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
  for (auto& change : changes_) {
    for (int axis = 0; axis < Dim; ++axis) change[axis] = step_ * random_.normal();
  }
  if (keeps_momentum_) take_off_mean();
  for (std::size_t i = 0; i < spheres_; ++i) {
    if (grains_.is_immobile(static_cast<std::int32_t>(i))) changes_[i] = {};
  }
  long double square = 0;
  for (const auto& change : changes_) square = std::max(square, dot(change, change));
  largest_ = std::sqrt(square);
}

/// Takes off what changes the momentum of all mobile spheres.
template <int Dim>
void Kicks<Dim>::take_off_mean() {
  Vec<Dim, long double> momentum;
  long double mass = 0;
  for (std::size_t at = 0; at < spheres_; ++at) {
    const auto i = static_cast<std::int32_t>(at);
    if (grains_.is_immobile(i)) continue;
    const long double own = grains_.mass(i);
    momentum += changes_[at] * own;
    mass += own;
  }
  for (auto& change : changes_) change -= momentum * (1 / mass);
}

#define ZENOSPHERE_INSTANTIATE(Dim) template class Kicks<Dim>;
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere::verify
