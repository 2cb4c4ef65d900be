#pragma once

#include <optional>

#include "model/vec.hpp"
#include "model/walls.hpp"

namespace zenosphere {

/// What acts on the spheres besides each other.
template <int Dim, class Real>
struct Surroundings {
  Vec<Dim, Real> acceleration{};       ///< diameters/time^2
  std::optional<Walls<Real>> walls{};  ///< their axis is the closed one of the box
};

}  // namespace zenosphere
