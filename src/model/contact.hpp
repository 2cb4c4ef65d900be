#pragma once

#include <cmath>
#include <optional>

#include "model/vec.hpp"

namespace zenosphere {

/// Sphere j as seen from sphere i, in one image: position and velocity belong together.
template <int Dim, class Real>
struct RelativeMotion {
  Vec<Dim, Real> dr;  ///< from i to j, diameters
  Vec<Dim, Real> dv;  ///< velocity of j minus velocity of i, diameters/time
};

/// Surface distance of two spheres over their mean diameter; negative where they overlap.
///
/// It is as good as the stored coordinates: within a cell of width w one unit in the last place
/// of a coordinate is at most 2^-53 w, so gaps below about 2e-16 are rounding.
///
/// \param sigma  mean diameter of the two: where their centres are at contact
template <int Dim, class Real>
Real gap(const Vec<Dim, Real>& dr, const Real& sigma = Real(1)) {
  using std::sqrt;
  return (sqrt(dot(dr, dr)) - sigma) / sigma;
}

/// When, and in which condition, an approaching pair touches.
template <class Real>
struct Contact {
  Real time;         ///< from now, in the unit of dv; <= 0 for a pair that overlaps already
  bool overlapping;  ///< the computed gap is <= 0 now, while the spheres approach
  Real approach;     ///< dr.dv < 0, diameters^2/time
};

/// What of a relative motion decides whether and when two spheres touch.
template <class Real>
struct Approach {
  Real b;   ///< dr.dv, diameters^2/time; negative while they approach
  Real v2;  ///< dv.dv
  Real r2;  ///< dr.dr
};

template <int Dim, class Real>
Approach<Real> approach(const RelativeMotion<Dim, Real>& motion) {
  return {dot(motion.dr, motion.dv), dot(motion.dv, motion.dv), dot(motion.dr, motion.dr)};
}

/// Squared distances are uncertain by far less, so that may_touch() loses no pair.
inline constexpr double approach_margin = 1e-9;

/// Whether a pair may touch: a test without |dr| that is enough to tell most pairs, which part or
/// miss, from those that contact() has to decide.
///
/// \param sigma  mean diameter of the two
template <class Real>
bool may_touch(const Approach<Real>& approach, const Real& sigma = Real(1)) {
  const auto& [b, v2, r2] = approach;
  const Real limit = sigma * sigma + approach_margin;
  return static_cast<bool>(static_cast<int>(b < 0) & static_cast<int>(b * b >= v2 * (r2 - limit)));
}

/// Time until two spheres touch, or nothing if they never do.
///
/// Solves |dr + dv t| = sigma for the earlier root, written so that the small root of a nearly
/// touching pair keeps its digits: c / (-b + sqrt(b^2 - v^2 c)) with
/// c = (|dr| - sigma)(|dr| + sigma). A pair that already overlaps while closing gives a time <= 0;
/// the overlap rule decides what that means.
///
/// \param sigma  mean diameter of the two
/// \return the contact, its time counted from now in the unit of dv
/// Source: Alder & Wainwright, J. Chem. Phys. 31 (1959) 459, eq. (7).
template <class Real>
std::optional<Contact<Real>> contact(const Approach<Real>& approach, const Real& sigma = Real(1)) {
  using std::sqrt;
  if (!may_touch(approach, sigma)) return std::nullopt;
  const auto& [b, v2, r2] = approach;
  const Real distance = sqrt(r2);
  const Real c = (distance - sigma) * (distance + sigma);
  const Real discriminant = b * b - v2 * c;
  if (discriminant < 0) return std::nullopt;
  return Contact<Real>{c / (-b + sqrt(discriminant)), c <= 0, b};
}

template <int Dim, class Real>
std::optional<Contact<Real>> contact(const RelativeMotion<Dim, Real>& motion,
                                     const Real& sigma = Real(1)) {
  return contact(approach(motion), sigma);
}

/// What one collision does: sphere j gains `impulse * normal`, sphere i loses it.
template <int Dim, class Real>
struct Impact {
  Vec<Dim, Real> normal;  ///< unit vector from i to j
  Real distance;          ///< of the centres, diameters; their mean diameter but for rounding
  Real normal_speed;      ///< closing speed, diameters/time; <= 0 if the pair recedes by rounding
  Real impulse;           ///< >= 0, mass diameter/time
};

/// How two spheres touch, before any impulse.
template <int Dim, class Real>
Impact<Dim, Real> touch(const RelativeMotion<Dim, Real>& motion) {
  using std::sqrt;
  const Real distance = sqrt(dot(motion.dr, motion.dr));
  Vec<Dim, Real> normal;
  for (int axis = 0; axis < Dim; ++axis) normal[axis] = motion.dr[axis] / distance;
  const Real normal_speed = -dot(normal, motion.dv);
  return {normal, distance, normal_speed, Real(0)};
}

/// The impulse along the normal: the relative velocity there is reversed and multiplied by the
/// restitution. A pair that recedes (rounding in the flight to a grazing contact) gets none.
///
/// \param restitution     in [0, 1]
/// \param inverse_masses  1/m_i + 1/m_j > 0, 1/mass
/// Source: Walton & Braun, J. Rheol. 30 (1986) 949; Brilliantov & Poeschel, Kinetic Theory of
/// Granular Gases (2004), eq. (2.6).
template <class Real>
Real normal_impulse(const Real& normal_speed, const Real& restitution,
                    const Real& inverse_masses = Real(2)) {
  return normal_speed > 0 ? Real((1 + restitution) * normal_speed / inverse_masses) : Real(0);
}

/// The collision of two smooth unit spheres with a constant coefficient of restitution.
///
/// \param motion  relative motion at contact
template <int Dim, class Real>
Impact<Dim, Real> impact(const RelativeMotion<Dim, Real>& motion, const Real& restitution) {
  Impact<Dim, Real> impact = touch(motion);
  impact.impulse = normal_impulse(impact.normal_speed, restitution);
  return impact;
}

}  // namespace zenosphere
