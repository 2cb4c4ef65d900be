#pragma once

#include <cstdint>
#include <optional>

#include "model/restitution/laws.hpp"

namespace zenosphere {

/// What a collision of two spheres does beyond a constant restitution. Each model is apart from the
/// others, and they combine.
template <class Real>
struct ContactModels {
  /// In the place of the constant restitution.
  std::optional<RestitutionLaws::Any<Real>> law{};
  /// TC model: a collision of a sphere whose last one was less than this ago is elastic; 0: never.
  /// Source: Luding & McNamara, Granular Matter 1 (1998) 113.
  Real contact_duration = 0;
  /// The relative velocity after a collision is turned by a random angle up to this, radians; 0: it
  /// is not. Source: Deltour & Barrat, J. Phys. I 7 (1997) 137.
  Real rotation_angle = 0;
  std::uint64_t seed = 1;  ///< of the random angles

  bool is_any() const { return law || contact_duration > 0 || rotation_angle > 0; }
};

}  // namespace zenosphere
