#include "flow/displacement_sums.hpp"

#include <algorithm>
#include <cmath>

#include "model/instantiate.hpp"

namespace zenosphere {
namespace {

constexpr double most_strain = 0.3;  // from sample to sample; what is then lacking: below 1 %
constexpr std::size_t most_numbers = std::size_t{1} << 24;  // in all origins: 128 MB

std::size_t level_count(std::size_t numbers_each, std::size_t most) {
  return std::clamp(most_numbers / std::max<std::size_t>(numbers_each, 1), std::size_t{1}, most);
}

}  // namespace

template <int Dim>
DisplacementSums<Dim>::DisplacementSums(const SampledSystem<Dim>& system)
    : system_(system),
      levels_(level_count(2 * Dim * static_cast<std::size_t>(system.spheres), most_levels)) {
  for (std::int32_t i = 0; i < system.spheres; ++i) mobile_ += !system.grains.is_immobile(i);
  has_common_motion_ =
      !system.closed_axis && system.spheres > 1 && mobile_ == static_cast<double>(system.spheres);
}

template <int Dim>
std::vector<SampledColumn> DisplacementSums<Dim>::columns() const {
  const std::size_t levels = levels_.size(), d = Dim;
  return {{"stretches", {levels}},
          {"moving_stretches", {levels}},
          {"square_displacements", {levels, lags, d}},
          {"velocity_correlations", {levels, lags}},
          {"uncertain_steps", {d}}};
}

template <int Dim>
std::vector<SampledEdges> DisplacementSums<Dim>::edges(double interval) const {
  return {{"lag", even_edges(0, interval, lags)}};
}

template <int Dim>
void DisplacementSums<Dim>::add(const SampledMoment<Dim>& moment,
                                const std::vector<Vector>& velocities, std::int64_t multiple,
                                double interval, SumsOfColumns& sums) {
  const Sums of_levels{sums.take(levels_.size()), sums.take(levels_.size()),
                       sums.take(levels_.size() * lags * Dim), sums.take(levels_.size() * lags)};
  go_on(moment, velocities, static_cast<double>(multiple - last_) * interval, sums.take(Dim));
  last_ = multiple;
  for (std::size_t n = 0; n < levels_.size(); ++n) {
    Level& level = levels_[n];
    const std::int64_t stride = std::int64_t{1} << n;
    if (multiple % stride != 0) continue;
    const std::int64_t lag = (multiple - level.begin) / stride;
    const bool goes_on = !level.moved.empty() && lag == static_cast<std::int64_t>(level.seen) + 1;
    if (goes_on) look(level, velocities);
    if (goes_on && level.seen < lags) continue;
    if (goes_on) end(n, of_levels);
    begin(level, velocities, multiple);
  }
}

/// Adds the stretch of a level, which is complete.
template <int Dim>
void DisplacementSums<Dim>::end(std::size_t n, const Sums& sums) const {
  const Level& level = levels_[n];
  const bool is_moving = level.square > 0;
  sums.stretches[n] += 1;
  sums.moving_stretches[n] += is_moving;
  for (std::size_t k = 0; k < lags; ++k) {
    const std::size_t lag = n * lags + k;
    for (int axis = 0; axis < Dim; ++axis) {
      sums.squares[lag * Dim + static_cast<std::size_t>(axis)] += level.squares[k][axis];
    }
    if (is_moving) sums.correlations[lag] += level.products[k] / level.square;
  }
}

/// Adds the steps since the last sample to what the spheres have moved; counts along which axes
/// the fastest could have come half a side, so that its image is not certain.
template <int Dim>
void DisplacementSums<Dim>::go_on(const SampledMoment<Dim>& moment,
                                  const std::vector<Vector>& velocities, double time,
                                  double* uncertain) {
  const Vector before = std::exchange(fastest_, Vector{});
  for (const Vector& velocity : velocities) {
    for (int axis = 0; axis < Dim; ++axis) {
      fastest_[axis] = std::max(fastest_[axis], std::abs(velocity[axis]));
    }
  }
  if (positions_.empty()) {
    moved_.resize(moment.positions.size());
  } else {
    std::vector<Vector> steps;
    for (std::size_t i = 0; i < positions_.size(); ++i) steps.push_back(step(i, moment, time));
    if (has_common_motion_) take_off_common(steps);
    for (std::size_t i = 0; i < steps.size(); ++i) moved_[i] += steps[i];
    const auto is_certain = [&](int axis) {
      const double farthest = std::max(before[axis], fastest_[axis]) * time;
      return system_.closed_axis == axis || farthest < system_.sides[axis] / 2;
    };
    const bool is_sheared = Dim > 1 && system_.shear_rate > 0;
    const bool flow_is_certain =
        !is_sheared || (is_certain(1 % Dim) && system_.shear_rate * time <= most_strain);
    for (int axis = 0; axis < Dim; ++axis) {
      uncertain[axis] += !is_certain(axis) || (axis == 0 && !flow_is_certain);
    }
  }
  positions_ = moment.positions;
}

/// From its last place to the nearest image of its place now, less the mean flow on the way.
template <int Dim>
Vec<Dim, double> DisplacementSums<Dim>::step(std::size_t i, const SampledMoment<Dim>& moment,
                                             double time) const {
  Vector step = moment.positions[i] - positions_[i];
  for (int axis = Dim - 1; axis >= 0; --axis) {  // y before x: its image is shifted along x
    if (axis == 0 && Dim > 1 && system_.shear_rate > 0) {
      const double height = positions_[i][1 % Dim] + step[1 % Dim] / 2 - system_.sides[1 % Dim] / 2;
      step[0] -= system_.shear_rate * time * height;
    }
    if (system_.closed_axis == axis) continue;
    const double turns = std::nearbyint(step[axis] / system_.sides[axis]);
    step[axis] -= turns * system_.sides[axis];
    if (axis == 1) step[0] -= turns * moment.offset;
  }
  return step;
}

template <int Dim>
void DisplacementSums<Dim>::take_off_common(std::vector<Vector>& steps) const {
  Vector sum;
  double mass = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double own = system_.grains.mass(static_cast<std::int32_t>(i));
    sum += steps[i] * own;
    mass += own;
  }
  for (Vector& each : steps) each -= sum * (1 / mass);
}

template <int Dim>
void DisplacementSums<Dim>::begin(Level& level, const std::vector<Vector>& velocities,
                                  std::int64_t multiple) const {
  level.begin = multiple;
  level.seen = 0;
  level.moved = moved_;
  level.velocities = velocities;
  level.square = mean_product(velocities, velocities);
}

template <int Dim>
void DisplacementSums<Dim>::look(Level& level, const std::vector<Vector>& velocities) const {
  Vector squares;
  for (std::size_t i = 0; i < moved_.size(); ++i) {
    if (system_.grains.is_immobile(static_cast<std::int32_t>(i))) continue;
    const Vector moved = moved_[i] - level.moved[i];
    for (int axis = 0; axis < Dim; ++axis) squares[axis] += moved[axis] * moved[axis];
  }
  level.squares[level.seen] = squares * (1 / mobile_);
  level.products[level.seen] = mean_product(level.velocities, velocities);
  ++level.seen;
}

template <int Dim>
double DisplacementSums<Dim>::mean_product(const std::vector<Vector>& a,
                                           const std::vector<Vector>& b) const {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!system_.grains.is_immobile(static_cast<std::int32_t>(i))) sum += dot(a[i], b[i]);
  }
  return sum / mobile_;
}

#define ZENOSPHERE_INSTANTIATE(Dim) template class DisplacementSums<Dim>;
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
