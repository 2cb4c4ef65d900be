#include "flow/wave_sums.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "model/instantiate.hpp"

namespace zenosphere {
namespace {

constexpr double long_k = 1.5;           // up to which S is taken for a parabola, 1/diameter
constexpr std::size_t least_shells = 3;  // of waves for that, where a box is small
constexpr double finest_bin = 0.05;      // 1/diameter: 300 bins to 15, as of snapshots
constexpr double rounding = 1e-9;        // of wavelengths
constexpr double slightly = 1.001;       // more than the third shell, for the same reason
constexpr double alike = 1e-6;           // lengths of waves, 1/diameter
constexpr double turn = 2 * std::numbers::pi;

/// exp(i n x) for n from 0 to `most`, one after the other.
struct Powers {
  std::vector<double> real, imaginary;

  explicit Powers(int most)
      : real(static_cast<std::size_t>(most) + 1, 1), imaginary(real.size(), 0) {}

  void take(double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    for (std::size_t n = 1; n < real.size(); ++n) {
      real[n] = real[n - 1] * c - imaginary[n - 1] * s;
      imaginary[n] = real[n - 1] * s + imaginary[n - 1] * c;
    }
  }
};

/// Adds w exp(i n x) of one sphere, for all n from 0 on, to as many sums.
void add_row(double w_real, double w_imaginary, const Powers& powers, double* real,
             double* imaginary) {
  for (std::size_t n = 0; n < powers.real.size(); ++n) {
    real[n] += w_real * powers.real[n] - w_imaginary * powers.imaginary[n];
    imaginary[n] += w_real * powers.imaginary[n] + w_imaginary * powers.real[n];
  }
}

/// Adds exp(i k r) of one sphere to the sums of all waves, those along the last axis innermost.
///
/// \param powers  of exp(2 pi i x / side), along each axis
void add_waves(const std::vector<Powers>& powers, double* real, double* imaginary) {
  const auto most = [&](std::size_t axis) {
    return axis + 1 < powers.size() ? static_cast<int>(powers[axis].real.size()) - 1 : 0;
  };
  const auto factor = [&](std::size_t axis, int n) {
    if (n == 0) return std::pair{1.0, 0.0};
    const auto size = static_cast<std::size_t>(std::abs(n));
    const double part = powers[axis].imaginary[size];
    return std::pair{powers[axis].real[size], n < 0 ? -part : part};
  };
  const std::size_t row = powers.back().real.size();
  for (int nx = -most(0); nx <= most(0); ++nx) {
    const auto [xr, xi] = factor(0, nx);
    for (int ny = -most(1); ny <= most(1); ++ny, real += row, imaginary += row) {
      const auto [yr, yi] = factor(1, ny);
      add_row(xr * yr - xi * yi, xr * yi + xi * yr, powers.back(), real, imaginary);
    }
  }
}

/// How many wavelengths up to k fit along each side; fewer where there were too many waves.
template <int Dim>
std::array<int, Dim> largest_numbers(const SampledSystem<Dim>& system, double k) {
  std::array<int, Dim> largest{};
  double waves = std::numeric_limits<double>::infinity();
  for (double part = 1; waves > WaveSums<Dim>::most_waves; part *= 0.9) {
    waves = 0.5;  // k and -k are the same
    for (int axis = 0; axis < Dim; ++axis) {
      if (system.closed_axis == axis) continue;
      const double most = std::floor((k * system.sides[axis] / turn + rounding) * part);
      largest[static_cast<std::size_t>(axis)] = std::max(static_cast<int>(most), 1);
      waves *= 2 * most + 1;
    }
  }
  return largest;
}

}  // namespace

template <int Dim>
WaveSums<Dim>::WaveSums(const SampledSystem<Dim>& system) : system_(system) {
  double side = 0;
  for (int axis = 0; axis < Dim; ++axis) {
    if (system.closed_axis != axis) side = std::max(side, system.sides[axis]);
  }
  if (side == 0) return;
  const double width = turn / side, step = std::max(width, finest_bin);
  longest_ = std::max(long_k, least_shells * width * slightly);
  largest_ = largest_numbers(system, longest_);
  double complete = longest_ + step / 2;  // below it all waves are there
  for (int axis = 0; axis < Dim; ++axis) {
    if (system.closed_axis == axis) continue;
    const double beyond = largest_[static_cast<std::size_t>(axis)] + 1;
    complete = std::min(complete, beyond * turn / system.sides[axis]);
  }
  const auto bins = static_cast<std::size_t>((complete - width / 2) / step + rounding);
  edges_ = even_edges(width / 2, step, bins);
}

template <int Dim>
std::vector<SampledColumn> WaveSums<Dim>::columns() const {
  if (!has_waves()) return {};
  const std::size_t bins = edges_.size() - 1;
  return {{"waves", {bins}},
          {"wave_numbers", {bins}},
          {"wave_powers", {bins}},
          {"structure_limits"},
          {"limit_samples"}};
}

template <int Dim>
std::vector<SampledEdges> WaveSums<Dim>::edges() const {
  if (!has_waves()) return {};
  return {{"wave_number", edges_}};
}

template <int Dim>
void WaveSums<Dim>::add(const SampledMoment<Dim>& moment, SumsOfColumns& sums) const {
  if (!has_waves()) return;
  const std::size_t bins = edges_.size() - 1;
  double* const counts = sums.take(bins);
  double* const lengths = sums.take(bins);
  double* const powers = sums.take(bins);
  const auto all = waves(amplitudes(moment), moment.offset);
  const double step = edges_[1] - edges_[0];
  for (const Wave& wave : all) {
    const double place = (wave.k - edges_[0]) / step;
    if (!(place >= 0 && place < static_cast<double>(bins))) continue;
    const auto bin = static_cast<std::size_t>(place);
    counts[bin] += wave.weight;
    lengths[bin] += wave.weight * wave.k;
    powers[bin] += wave.weight * wave.power;
  }
  const auto at_zero = limit(all);
  *sums.take(1) += at_zero.value_or(0);
  *sums.take(1) += at_zero.has_value();
}

/// Sums of exp(i k r) over the spheres of a sample, for all waves and k = 0.
template <int Dim>
auto WaveSums<Dim>::amplitudes(const SampledMoment<Dim>& moment) const -> Amplitudes {
  std::size_t waves = 1;
  std::vector<Powers> powers;
  for (int axis = 0; axis < Dim; ++axis) {
    const int most = largest_[static_cast<std::size_t>(axis)];
    waves *= static_cast<std::size_t>(axis == Dim - 1 ? most + 1 : 2 * most + 1);
    powers.emplace_back(most);
  }
  Amplitudes sums{std::vector<double>(waves), std::vector<double>(waves)};
  for (const Vector& place : moment.positions) {
    for (int axis = 0; axis < Dim; ++axis) {
      double part = place[axis] / system_.sides[axis];
      if (axis == 0 && Dim > 1) {
        part -= place[1 % Dim] / system_.sides[1 % Dim] * moment.offset / system_.sides[0];
      }
      powers[static_cast<std::size_t>(axis)].take(turn * part);
    }
    add_waves(powers, sums.real.data(), sums.imaginary.data());
  }
  return sums;
}

/// The waves of these amplitudes, in the same order, without that of k = 0.
template <int Dim>
auto WaveSums<Dim>::waves(const Amplitudes& amplitudes, double offset) const -> std::vector<Wave> {
  std::vector<Wave> waves;
  std::array<int, Dim> number{};
  for (int axis = 0; axis < Dim - 1; ++axis) number[at(axis)] = -largest_[at(axis)];
  for (std::size_t n = 0; n < amplitudes.real.size(); ++n) {
    const double square =
        amplitudes.real[n] * amplitudes.real[n] + amplitudes.imaginary[n] * amplitudes.imaginary[n];
    const double weight = number[Dim - 1] > 0 ? 2 : 1;
    if (const double k = length(number, offset); k > 0) {
      waves.push_back({k, weight, square / system_.spheres});
    }
    for (int axis = Dim - 1; axis >= 0 && ++number[at(axis)] > largest_[at(axis)]; --axis) {
      number[at(axis)] = axis == Dim - 1 ? 0 : -largest_[at(axis)];
    }
  }
  return waves;
}

/// |k| of a wave in the slanted box.
template <int Dim>
double WaveSums<Dim>::length(const std::array<int, Dim>& number, double offset) const {
  Vector k;
  for (int axis = 0; axis < Dim; ++axis) k[axis] = number[at(axis)] / system_.sides[axis];
  if constexpr (Dim > 1) k[1] -= k[0] * offset / system_.sides[1];
  return turn * std::sqrt(dot(k, k));
}

/// S(0) by least squares over the long waves; nothing where they have too few lengths.
template <int Dim>
std::optional<double> WaveSums<Dim>::limit(const std::vector<Wave>& waves) const {
  double one = 0, square = 0, fourth = 0, power = 0, power_square = 0;
  std::vector<double> lengths;
  for (const auto& [k, weight, value] : waves) {
    if (k > longest_) continue;
    const double k2 = k * k;
    one += weight;
    square += weight * k2;
    fourth += weight * k2 * k2;
    power += weight * value;
    power_square += weight * value * k2;
    lengths.push_back(k);
  }
  std::sort(lengths.begin(), lengths.end());
  const auto same = [](double a, double b) { return b - a < alike; };
  lengths.erase(std::unique(lengths.begin(), lengths.end(), same), lengths.end());
  if (lengths.size() < least_shells) return std::nullopt;
  return (fourth * power - square * power_square) / (one * fourth - square * square);
}

#define ZENOSPHERE_INSTANTIATE(Dim) template class WaveSums<Dim>;
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
