#include "flow/layer_sums.hpp"

#include <cmath>

#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim>
Layers<Dim>::Layers(const SampledSystem<Dim>& system)
    : axis(system.profile_axis()), side(system.sides[axis]) {
  constexpr double most = 200;
  const double thickness = system.closed_axis ? 0.5 : 1;
  count = static_cast<std::size_t>(std::clamp(std::nearbyint(side / thickness), 1.0, most));
}

template <int Dim>
std::size_t Layers<Dim>::at(double height) const {
  const double inside = height - side * std::floor(height / side);
  return std::min(static_cast<std::size_t>(inside / width()), count - 1);
}

template <int Dim>
std::vector<SampledColumn> LayerSums<Dim>::columns() const {
  const std::size_t count = layers_.count, d = Dim;
  return {{"layer_spheres", {count}},
          {"layer_mass", {count}},
          {"layer_momentum", {count, d}},
          {"layer_kinetic", {count, d, d}},
          {"layer_diameters", {count, system_.kinds()}}};
}

template <int Dim>
std::vector<SampledEdges> LayerSums<Dim>::edges() const {
  return {{"layer", even_edges(0, layers_.width(), layers_.count)}};
}

template <int Dim>
void LayerSums<Dim>::add(const SampledMoment<Dim>& moment, SumsOfColumns& sums) const {
  const auto& grains = system_.grains;
  const std::size_t count = layers_.count, kinds = system_.kinds();
  double* const spheres = sums.take(count);
  double* const masses = sums.take(count);
  double* const momenta = sums.take(count * Dim);
  double* const kinetic = sums.take(count * Dim * Dim);
  double* const diameters = sums.take(count * kinds);
  for (std::int32_t i = 0; i < system_.spheres; ++i) {
    const auto n = static_cast<std::size_t>(i);
    const std::size_t layer = layers_.at(moment.positions[n][layers_.axis]);
    diameters[layer * kinds + static_cast<std::size_t>(grains.kind(i))] +=
        std::pow(grains.diameter(i), Dim);
    if (grains.is_immobile(i)) continue;
    const auto& velocity = moment.velocities[n];
    const double mass = grains.mass(i);
    ++spheres[layer];
    masses[layer] += mass;
    for (int a = 0; a < Dim; ++a) {
      momenta[layer * Dim + static_cast<std::size_t>(a)] += mass * velocity[a];
      for (int b = 0; b < Dim; ++b) {
        kinetic[layer * Dim * Dim + static_cast<std::size_t>(a * Dim + b)] +=
            mass * velocity[a] * velocity[b];
      }
    }
  }
}

#define ZENOSPHERE_INSTANTIATE(Dim) \
  template struct Layers<Dim>;      \
  template class LayerSums<Dim>;
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
