#include "flow/streaks.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim, class Real>
std::vector<double> streak_amplitudes(const Simulation<Dim, Real>& simulation) {
  constexpr std::size_t modes = count_of_streak_modes<Dim>();
  std::array<std::complex<double>, streak_modes.size()> sums{};
  const auto& sides = simulation.box().sides();
  const auto wave = [&](const Vec<Dim, Real>& place, int axis) {
    const auto phase = 2 * std::numbers::pi * static_cast<double>(place[axis] / sides[axis]);
    return std::complex<double>(std::cos(phase), -std::sin(phase));
  };
  const auto& grains = simulation.grains();
  double total = 0;
  for (std::int32_t i = 0; i < simulation.spheres(); ++i) {
    if (grains.is_immobile(i)) continue;
    const auto mass = static_cast<double>(grains.mass(i));
    const double momentum = mass * static_cast<double>(simulation.peculiar_velocity(i)[0]);
    const Vec<Dim, Real> place = simulation.place_across_flow(i);
    total += mass;
    if constexpr (Dim == 2) sums[0] += momentum * wave(place, 1);
    if constexpr (Dim == 3) {
      const auto y = wave(place, 1), z = wave(place, 2);
      const double even = y.real() * z.real(), odd = y.imag() * z.imag();
      const double y_first = y.imag() * z.real(), z_first = y.real() * z.imag();
      sums[0] += momentum * y;
      sums[1] += momentum * z;
      sums[2] += std::complex<double>(momentum * (even - odd), momentum * (y_first + z_first));
      sums[3] += std::complex<double>(momentum * (even + odd), momentum * (y_first - z_first));
    }
  }
  std::vector<double> amplitudes;
  for (std::size_t mode = 0; mode < modes; ++mode) {
    amplitudes.push_back(2 * std::abs(sums[mode]) / total);
  }
  return amplitudes;
}

double streak_temperature(const Observables& averages, const Inertia& inertia) {
  double sum = 0;
  for (const double amplitude : averages.streak_modes) {
    sum += inertia.mean_mass * amplitude * amplitude / 2 -
           2 * averages.temperature_diagonal[0] / inertia.spheres;
  }
  return sum;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) \
  template std::vector<double> streak_amplitudes<Dim, Real>(const Simulation<Dim, Real>&);
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
