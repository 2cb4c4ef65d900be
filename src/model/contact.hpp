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

/// Surface distance of two unit spheres, in diameters; negative where they overlap.
///
/// It is as good as the stored coordinates: within a cell of width w one unit in the last place
/// of a coordinate is at most 2^-53 w, so gaps below about 2e-16 are rounding.
template <int Dim, class Real>
Real gap(const Vec<Dim, Real>& dr) {
  using std::sqrt;
  return sqrt(dot(dr, dr)) - 1;
}

/// When, and in which condition, an approaching pair touches.
template <class Real>
struct Contact {
  Real time;         ///< from now, in the unit of dv; <= 0 for a pair that overlaps already
  bool overlapping;  ///< the computed gap is <= 0 now, while the spheres approach
  Real approach;     ///< dr.dv < 0, diameters^2/time
};

/// Time until two unit-diameter spheres touch, or nothing if they never do.
///
/// Solves |dr + dv t| = 1 for the earlier root, written so that the small root of a nearly
/// touching pair keeps its digits: c / (-b + sqrt(b^2 - v^2 c)) with c = (|dr| - 1)(|dr| + 1).
/// A pair that already overlaps while closing gives a time <= 0; the overlap rule decides what
/// that means.
///
/// \param motion  relative motion in one image; lengths in diameters
/// \return        the contact, its time counted from now in the unit of motion.dv
/// Source: Alder & Wainwright, J. Chem. Phys. 31 (1959) 459, eq. (7).
template <int Dim, class Real>
std::optional<Contact<Real>> contact(const RelativeMotion<Dim, Real>& motion) {
  using std::sqrt;
  const Real b = dot(motion.dr, motion.dv);
  const Real v2 = dot(motion.dv, motion.dv);
  const Real r2 = dot(motion.dr, motion.dr);
  // Most pairs part or miss. One test without |dr| tells nearly all of them: the margin is far
  // above the rounding of r2 - 1, so that no pair is lost that the exact discriminant would keep.
  const Real margin = 1e-9;
  if (!(static_cast<int>(b < 0) & static_cast<int>(b * b >= v2 * (r2 - (1 + margin))))) {
    return std::nullopt;
  }
  const Real distance = sqrt(r2);
  const Real c = (distance - 1) * (distance + 1);
  const Real discriminant = b * b - v2 * c;
  if (discriminant < 0) return std::nullopt;
  return Contact<Real>{c / (-b + sqrt(discriminant)), c <= 0, b};
}

/// What one collision does: sphere j gains `impulse * normal`, sphere i loses it.
template <int Dim, class Real>
struct Impact {
  Vec<Dim, Real> normal;  ///< unit vector from i to j
  Real distance;          ///< of the centres, diameters; 1 but for rounding
  Real normal_speed;      ///< closing speed, diameters/time; <= 0 if the pair recedes by rounding
  Real impulse;           ///< >= 0, mass diameter/time
};

/// The collision of two smooth equal spheres with a constant coefficient of restitution.
///
/// The relative velocity along the line of centres is reversed and multiplied by `restitution`;
/// the tangential one stays. A pair that recedes (rounding in the flight to a grazing contact)
/// gets no impulse.
///
/// \param motion       relative motion at contact
/// \param restitution  in [0, 1]
/// Source: Walton & Braun, J. Rheol. 30 (1986) 949; Brilliantov & Poeschel, Kinetic Theory of
/// Granular Gases (2004), eq. (2.6).
template <int Dim, class Real>
Impact<Dim, Real> impact(const RelativeMotion<Dim, Real>& motion, const Real& restitution) {
  using std::sqrt;
  const Real distance = sqrt(dot(motion.dr, motion.dr));
  Vec<Dim, Real> normal;
  for (int axis = 0; axis < Dim; ++axis) normal[axis] = motion.dr[axis] / distance;
  const Real normal_speed = -dot(normal, motion.dv);
  const Real impulse = normal_speed > 0 ? Real((1 + restitution) * normal_speed / 2) : Real(0);
  return {normal, distance, normal_speed, impulse};
}

}  // namespace zenosphere
