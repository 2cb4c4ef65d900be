#pragma once

namespace zenosphere {

/// Coulomb's coefficient of friction; infinite where nothing ever slides.
struct Friction {
  double coefficient = 0;
  friend bool operator==(const Friction&, const Friction&) = default;
};

/// Every contact sticks then; more is "unbounded".
inline constexpr double most_friction = 1e100;

}  // namespace zenosphere
