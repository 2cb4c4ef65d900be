#pragma once

#include <array>
#include <optional>
#include <vector>

#include "flow/sampled_system.hpp"

namespace zenosphere {

/// The static structure factor of long waves, S(k) = |sum of exp(i k r)|^2 / N, and its limit at
/// k = 0: the constant of a parabola S(0) + a k^2.
///
/// Waves are all those that fit into the box, the slanted one under shear, with |k| up to 1.5, or
/// the three longest along a side; in a large system fewer, so that no more than `most_waves` are
/// summed over the spheres. The same as zenosphere analyse finds in a snapshot, defined in
/// docs/measurements.md.
template <int Dim>
class WaveSums {
 public:
  static constexpr double most_waves = 1200;

  explicit WaveSums(const SampledSystem<Dim>& system);

  std::vector<SampledColumn> columns() const;
  std::vector<SampledEdges> edges() const;

  /// Adds a sample to the sums of `columns()`.
  void add(const SampledMoment<Dim>& moment, SumsOfColumns& sums) const;

 private:
  using Vector = Vec<Dim, double>;
  struct Wave {
    double k, weight, power;  ///< |k|, 1/diameter; 2 for k and -k; |sum of exp(i k r)|^2 / N
  };

  struct Amplitudes {
    std::vector<double> real, imaginary;
  };

  static std::size_t at(int axis) { return static_cast<std::size_t>(axis); }
  bool has_waves() const { return !edges_.empty(); }
  Amplitudes amplitudes(const SampledMoment<Dim>& moment) const;
  std::vector<Wave> waves(const Amplitudes& amplitudes, double offset) const;
  double length(const std::array<int, Dim>& number, double offset) const;
  std::optional<double> limit(const std::vector<Wave>& waves) const;

  SampledSystem<Dim> system_;
  std::array<int, Dim> largest_{};  ///< wavelengths along each side
  double longest_ = 0;              ///< k up to which the limit is taken
  std::vector<double> edges_;       ///< of the bins of k
};

}  // namespace zenosphere
