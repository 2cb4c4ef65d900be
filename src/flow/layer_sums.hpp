#pragma once

#include <vector>

#include "flow/sampled_system.hpp"

namespace zenosphere {

/// The layers of a box, of about a diameter each, between walls half of one.
template <int Dim>
struct Layers {
  int axis;
  double side;
  std::size_t count;

  explicit Layers(const SampledSystem<Dim>& system);
  double width() const { return side / static_cast<double>(count); }
  /// The layer at a height, which counts modulo the side.
  std::size_t at(double height) const;
};

/// What is in each layer across the gradient or between the walls: profiles are made of it.
template <int Dim>
class LayerSums {
 public:
  explicit LayerSums(const SampledSystem<Dim>& system) : system_(system), layers_(system) {}

  std::vector<SampledColumn> columns() const;
  std::vector<SampledEdges> edges() const;

  /// Adds the spheres of a sample by their centres: mobile ones, with their masses, momenta and
  /// m v_a v_b relative to the imposed profile; diameter^D of all, by kinds.
  void add(const SampledMoment<Dim>& moment, SumsOfColumns& sums) const;

 private:
  SampledSystem<Dim> system_;
  Layers<Dim> layers_;
};

}  // namespace zenosphere
