#pragma once

#include <optional>

#include "model/vec.hpp"
#include "model/walls.hpp"

namespace zenosphere {

/// What acts on the spheres besides each other.
template <int Dim, class Real>
struct Surroundings {
  Vec<Dim, Real> acceleration{};       ///< of all that are not immobile, diameters/time^2
  std::optional<Walls<Real>> walls{};  ///< their axis is the closed one of the box
  bool all_fall = true;                ///< none is immobile where there is an acceleration

  /// With which all spheres fall, and a frame can fall with them.
  Vec<Dim, Real> common_acceleration() const { return all_fall ? acceleration : Vec<Dim, Real>{}; }
};

}  // namespace zenosphere
