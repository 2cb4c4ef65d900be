#pragma once

#include <limits>
#include <vector>

#include "flow/layer_sums.hpp"
#include "flow/sampled_system.hpp"

namespace zenosphere {

/// Distributions over collisions, and where and between which kinds energy is lost and momentum
/// handed over.
template <int Dim, class Real>
class CollisionSums {
 public:
  CollisionSums(const SampledSystem<Dim>& system, const Simulation<Dim, Real>& simulation);

  std::vector<SampledColumn> columns() const;
  std::vector<SampledEdges> edges() const;

  /// To be called after each collision, in order.
  ///
  /// \param sums  those of `columns()`; null: nothing counts yet
  void observe(const Collision<Dim, Real>& collision, const Simulation<Dim, Real>& simulation,
               double* sums);

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    const std::size_t spheres = self.last_.size();
    archive(self.last_, self.has_collided_);
    require_archived(self.last_.size() == spheres && self.has_collided_.size() == spheres,
                     "flights of another number of spheres");
  }

 private:
  void add_flight(std::int32_t sphere, const Collision<Dim, Real>& collision, double* counts,
                  double* moments);
  void add_pair(const Collision<Dim, Real>& collision, const Simulation<Dim, Real>& simulation,
                SumsOfColumns& sums) const;
  void add_transfer(const Collision<Dim, Real>& collision, double height, double* transfer) const;
  double impact_angle(const Collision<Dim, Real>& collision,
                      const Simulation<Dim, Real>& simulation) const;

  SampledSystem<Dim> system_;
  Layers<Dim> layers_;
  Real clock_unit_;
  std::vector<Instant<Real>> last_;  ///< collision of each sphere
  std::vector<std::uint8_t> has_collided_;
};

}  // namespace zenosphere
