#pragma once

namespace zenosphere {

/// What a law of restitution has to know of two spheres beside their speed; by default of two unit
/// spheres.
template <class Real>
struct CollidingPair {
  Real inverse_masses = 2;  ///< 1/m_i + 1/m_j > 0, 1/mass
  Real diameter = 1;        ///< of equal spheres as curved at the contact, 2 s_i s_j / (s_i + s_j)
};

}  // namespace zenosphere
