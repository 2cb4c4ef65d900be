#pragma once

#include <cstdint>
#include <span>

#include "engine/simulation.hpp"

namespace zenosphere {

/// Where all spheres are at one moment, to ask how close those of a cluster are.
template <int Dim, class Real>
class ClusterGaps {
 public:
  /// The moment at which the simulation is now.
  explicit ClusterGaps(const Simulation<Dim, Real>& simulation);

  /// The smallest gap of a cluster: of two of its spheres, or of one and a wall.
  ///
  /// Two that have just collided are in contact, and recede: one such contact is passed over.
  ///
  /// \param spheres  of the cluster
  /// \param limit    decades told for spheres that touch or overlap
  /// \return         decades, >= 0; 0 also where there is no gap to speak of
  double smallest(std::span<const std::int32_t> spheres, double limit) const;

  struct Relative {
    Vec<Dim, Real> dr;  ///< by the shortest image, diameters
    Vec<Dim, Real> dv;  ///< of that image, diameters/time
  };
  /// How sphere i sees sphere j.
  Relative relative(std::int32_t i, std::int32_t j) const;

  std::int32_t spheres() const { return static_cast<std::int32_t>(state_.positions.size()); }
  const ShearBox<Dim, Real>& box() const { return box_; }
  const Grains<Real>& grains() const { return state_.grains; }

 private:
  ShearBox<Dim, Real> box_;
  Real offset_ = 0;  ///< of the images along y
  Configuration<Dim, Real> state_;
};

}  // namespace zenosphere
