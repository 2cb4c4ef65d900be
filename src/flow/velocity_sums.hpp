#pragma once

#include <vector>

#include "flow/sampled_system.hpp"

namespace zenosphere {

/// How the peculiar velocities of a sample are spread: moments and histograms.
///
/// Velocities are relative to the mean of all spheres, between walls to that of layers of about a
/// hundred; of spheres that differ the mean by mass. Each counts in units of sqrt(T / m), T the
/// temperature of its kind in this sample; immobile spheres do not. As zenosphere analyse has it.
template <int Dim>
class VelocitySums {
 public:
  explicit VelocitySums(const SampledSystem<Dim>& system);

  std::vector<SampledColumn> columns() const;
  std::vector<SampledEdges> edges() const;

  /// Adds a sample to the sums of `columns()`.
  void add(const SampledMoment<Dim>& moment, SumsOfColumns& sums) const;

  /// Velocities relative to these means, diameters/time.
  std::vector<Vec<Dim, double>> peculiar(const SampledMoment<Dim>& moment) const;

 private:
  using Vector = Vec<Dim, double>;
  struct Moments {
    double temperature = 0, a2 = 0, a3 = 0;
    bool has_distribution = false;
  };

  void take_off_mean(std::vector<Vector>& velocities, const std::int32_t* first,
                     const std::int32_t* last) const;
  std::vector<double> temperatures(const std::vector<Vector>& velocities) const;
  void add_kinds(const std::vector<Vector>& velocities, const std::vector<double>& temperatures,
                 SumsOfColumns& sums) const;

  SampledSystem<Dim> system_;
  std::vector<std::int32_t> mobile_;
};

}  // namespace zenosphere
