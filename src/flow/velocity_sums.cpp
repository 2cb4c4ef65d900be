#include "flow/velocity_sums.hpp"

#include <cmath>
#include <numeric>

#include "model/instantiate.hpp"

namespace zenosphere {
namespace {

constexpr double velocity_bin = 0.1;       // in units of sqrt(T / m)
constexpr std::size_t velocity_bins = 80;  // up to 8 of them, on each side
constexpr std::int32_t in_a_layer = 100;   // spheres whose mean velocity is that of a place

/// a2 and a3 of energies: how far they are from those of a Maxwellian.
struct Sonine {
  double a2, a3;
};

/// Corrected for the conserved momentum, so that 0 is the expectation for a Maxwellian.
///
/// \param squares  v^2 or m v^2 of two spheres or more, not all 0
/// Source: Brilliantov & Poeschel, Europhys. Lett. 74 (2006) 424.
Sonine sonine(const std::vector<double>& squares, double dimension) {
  const auto number = static_cast<double>(squares.size()), d = dimension;
  const double mean = std::accumulate(squares.begin(), squares.end(), 0.0) / number;
  double fourth = 0, sixth = 0;
  for (const double square : squares) {
    const double ratio = square / mean;
    fourth += ratio * ratio;
    sixth += ratio * ratio * ratio;
  }
  const double free = (number - 1) * d;  // components that are independent of each other
  fourth *= (free + 2) / free / number;
  sixth *= (free + 2) * (free + 4) / (free * free) / number;
  const double a2 = d / (d + 2) * fourth - 1;
  return {a2, 1 + 3 * a2 - d * d / ((d + 2) * (d + 4)) * sixth};
}

/// Counts a value in bins from `first` on; one beyond the last bin is left out.
void count_in(double* counts, std::size_t bins, double first, double value) {
  const double place = (value - first) / velocity_bin;
  if (place >= 0 && place < static_cast<double>(bins)) ++counts[static_cast<std::size_t>(place)];
}

}  // namespace

template <int Dim>
VelocitySums<Dim>::VelocitySums(const SampledSystem<Dim>& system) : system_(system) {
  for (std::int32_t i = 0; i < system.spheres; ++i) {
    if (!system.grains.is_immobile(i)) mobile_.push_back(i);
  }
}

template <int Dim>
std::vector<SampledColumn> VelocitySums<Dim>::columns() const {
  std::vector<SampledColumn> columns{{"granular_temperatures"},
                                     {"velocity_samples"},
                                     {"velocities"},
                                     {"sonine_a2"},
                                     {"sonine_a3"},
                                     {"component_counts", {2 * velocity_bins}},
                                     {"speed_counts", {velocity_bins}},
                                     {"speeds"}};
  if (system_.grains.are_alike()) return columns;
  for (const char* name :
       {"temperatures_of_kind", "samples_of_kind", "sonine_a2_of_kind", "sonine_a3_of_kind"}) {
    columns.push_back({name, {system_.kinds()}});
  }
  return columns;
}

template <int Dim>
std::vector<SampledEdges> VelocitySums<Dim>::edges() const {
  const double fastest = velocity_bin * velocity_bins;
  return {{"velocity_component", even_edges(-fastest, velocity_bin, 2 * velocity_bins)},
          {"speed", even_edges(0, velocity_bin, velocity_bins)}};
}

template <int Dim>
void VelocitySums<Dim>::add(const SampledMoment<Dim>& moment, SumsOfColumns& sums) const {
  const auto velocities = peculiar(moment);
  const auto of_kinds = temperatures(velocities);
  std::vector<double> squares;
  double energy = 0, speed = 0;
  for (const std::int32_t i : mobile_) {
    const auto& velocity = velocities[static_cast<std::size_t>(i)];
    const double kind = of_kinds[static_cast<std::size_t>(system_.grains.kind(i))];
    const double square = dot(velocity, velocity);
    energy += system_.grains.mass(i) * square;
    if (kind > 0) squares.push_back(system_.grains.mass(i) * square / kind);
  }
  for (const Vector& velocity : velocities) speed += std::sqrt(dot(velocity, velocity));
  const bool is_spread = squares.size() == mobile_.size() && mobile_.size() > 1;
  *sums.take(1) += energy / (Dim * static_cast<double>(mobile_.size()));
  *sums.take(1) += is_spread;
  *sums.take(1) += is_spread ? static_cast<double>(mobile_.size()) : 0;
  const Sonine found = is_spread ? sonine(squares, Dim) : Sonine{0, 0};
  *sums.take(1) += found.a2;
  *sums.take(1) += found.a3;
  double* const components = sums.take(2 * velocity_bins);
  double* const speeds = sums.take(velocity_bins);
  *sums.take(1) += speed / static_cast<double>(velocities.size());
  for (std::size_t n = 0; is_spread && n < mobile_.size(); ++n) {
    const std::int32_t i = mobile_[n];
    const double kind = of_kinds[static_cast<std::size_t>(system_.grains.kind(i))];
    const double unit = std::sqrt(kind / system_.grains.mass(i));
    const Vector& velocity = velocities[static_cast<std::size_t>(i)];
    for (int axis = 0; axis < Dim; ++axis) {
      count_in(components, 2 * velocity_bins, -velocity_bin * velocity_bins, velocity[axis] / unit);
    }
    count_in(speeds, velocity_bins, 0, std::sqrt(squares[n]));
  }
  if (!system_.grains.are_alike()) add_kinds(velocities, of_kinds, sums);
}

template <int Dim>
void VelocitySums<Dim>::add_kinds(const std::vector<Vector>& velocities,
                                  const std::vector<double>& temperatures,
                                  SumsOfColumns& sums) const {
  std::vector<std::vector<double>> energies(system_.kinds());
  for (const std::int32_t i : mobile_) {
    const auto& velocity = velocities[static_cast<std::size_t>(i)];
    energies[static_cast<std::size_t>(system_.grains.kind(i))].push_back(system_.grains.mass(i) *
                                                                         dot(velocity, velocity));
  }
  double* const of_kind = sums.take(system_.kinds());
  double* const samples = sums.take(system_.kinds());
  double* const a2 = sums.take(system_.kinds());
  double* const a3 = sums.take(system_.kinds());
  for (std::size_t kind = 0; kind < system_.kinds(); ++kind) {
    of_kind[kind] += temperatures[kind];
    if (energies[kind].size() < 2 || !(temperatures[kind] > 0)) continue;
    const Sonine found = sonine(energies[kind], Dim);
    ++samples[kind];
    a2[kind] += found.a2;
    a3[kind] += found.a3;
  }
}

/// Velocities relative to the mean of the place.
template <int Dim>
std::vector<Vec<Dim, double>> VelocitySums<Dim>::peculiar(const SampledMoment<Dim>& moment) const {
  auto velocities = moment.velocities;
  std::vector<std::int32_t> order(velocities.size());
  std::iota(order.begin(), order.end(), 0);
  if (order.size() < 2) return velocities;
  if (!system_.closed_axis) {
    take_off_mean(velocities, order.data(), order.data() + order.size());
    return velocities;
  }
  const int axis = *system_.closed_axis;
  const auto height = [&](std::int32_t i) {
    return moment.positions[static_cast<std::size_t>(i)][axis];
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::int32_t i, std::int32_t j) { return height(i) < height(j); });
  const std::int32_t layers = std::max(system_.spheres / in_a_layer, 1);
  const std::int32_t size = system_.spheres / layers, larger = system_.spheres % layers;
  const std::int32_t* first = order.data();
  for (std::int32_t layer = 0; layer < layers; ++layer) {
    const std::int32_t* const last = first + size + (layer < larger ? 1 : 0);
    take_off_mean(velocities, first, last);
    first = last;
  }
  return velocities;
}

template <int Dim>
void VelocitySums<Dim>::take_off_mean(std::vector<Vector>& velocities, const std::int32_t* first,
                                      const std::int32_t* last) const {
  Vector momentum;
  double mass = 0;
  for (const std::int32_t* i = first; i != last; ++i) {
    if (system_.grains.is_immobile(*i)) continue;
    momentum += velocities[static_cast<std::size_t>(*i)] * system_.grains.mass(*i);
    mass += system_.grains.mass(*i);
  }
  if (mass == 0) return;
  for (const std::int32_t* i = first; i != last; ++i) {
    velocities[static_cast<std::size_t>(*i)] -= momentum * (1 / mass);
  }
}

/// Mean of m v^2 / D over the mobile spheres of each kind; NaN where there are none.
template <int Dim>
std::vector<double> VelocitySums<Dim>::temperatures(const std::vector<Vector>& velocities) const {
  std::vector<double> energy(system_.kinds()), number(system_.kinds());
  for (const std::int32_t i : mobile_) {
    const auto kind = static_cast<std::size_t>(system_.grains.kind(i));
    const auto& velocity = velocities[static_cast<std::size_t>(i)];
    energy[kind] += system_.grains.mass(i) * dot(velocity, velocity) / Dim;
    ++number[kind];
  }
  for (std::size_t kind = 0; kind < energy.size(); ++kind) energy[kind] /= number[kind];
  return energy;
}

#define ZENOSPHERE_INSTANTIATE(Dim) template class VelocitySums<Dim>;
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
