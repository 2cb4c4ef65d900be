#pragma once

#include <vector>

#include "flow/sampled_system.hpp"

namespace zenosphere {

/// Counts the pairs of a sample by their distance: what radial distributions are made of.
///
/// Of unit spheres: counts in bins of 0.02 diameters, both ways; under shear also in 12 sectors of
/// the angle between the pair and the flow, in the plane of flow and gradient; and g at contact,
/// for which g(r) counts as a cubic near contact (a projection on Legendre polynomials). Of spheres
/// that differ: counts of all, and by kinds against the distance over the mean diameter. The same
/// as zenosphere analyse finds in a snapshot, defined in docs/measurements.md.
template <int Dim>
class PairSums {
 public:
  explicit PairSums(const SampledSystem<Dim>& system);

  std::vector<SampledColumn> columns() const;
  std::vector<SampledEdges> edges() const;

  /// Adds a sample to the sums of `columns()`, from `sums` on.
  void add(const SampledMoment<Dim>& moment, SumsOfColumns& sums) const;

 private:
  struct Bins {
    double first = 1;
    std::vector<double> edges{};
    std::size_t count() const { return edges.size() - 1; }
    /// The bin of a distance, which lies in one of them; the last one is closed.
    std::size_t of(double distance) const;
  };
  static Bins bins(double first, double last);

  bool is_counted() const { return system_.spheres > 1; }
  void add_alike(const SampledMoment<Dim>& moment, SumsOfColumns& sums) const;
  void add_unlike(const SampledMoment<Dim>& moment, SumsOfColumns& sums) const;
  double volume_of_centres() const;
  double share_inside(const SampledMoment<Dim>& moment, double distance) const;
  std::vector<double> shares_at_contact(const SampledMoment<Dim>& moment) const;

  SampledSystem<Dim> system_;
  bool are_alike_;
  double largest_ = 1;
  double contact_width_;  ///< over which g counts as a cubic, diameters or mean diameters
  Bins bins_, partial_bins_;
};

}  // namespace zenosphere
