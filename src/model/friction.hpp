#pragma once

#include <cmath>

#include "model/contact_table.hpp"
#include "model/spin.hpp"
#include "model/vec.hpp"

namespace zenosphere {

/// What rubs in a contact of rough surfaces.
template <int Dim, class Real>
struct Rubbing {
  Vec<Dim, Real> impulse;  ///< that the second one gains, across the normal, mass diameter/time
  Real loss = 0;           ///< energy that it takes, mass diameter^2/time^2
  bool slides = false;     ///< friction was at its limit; otherwise the surfaces have stuck
};

/// Velocity of the surface of the second sphere relative to that of the first at their contact,
/// across the normal.
///
/// \param dv      velocity of the centre of the second minus that of the first
/// \param turned  radius x spin, summed over the two, diameters/time
template <int Dim, class Real>
Vec<Dim, Real> sliding_velocity(const Vec<Dim, Real>& dv, const Vec<Dim, Real>& normal,
                                const Spin<Dim, Real>& turned) {
  const Vec<Dim, Real> surface = dv - turning_velocity<Dim, Real>(turned, normal);
  return surface - normal * dot(normal, surface);
}

/// The tangential impulse of Walton's law with its three parameters.
///
/// While the surfaces stick, their relative velocity is multiplied by -beta0; the impulse that this
/// takes is at most mu times the normal one, and then they slide.
///
/// \param sliding   velocity of the surface of the second, across the normal
/// \param normal    impulse along the normal, > 0
/// \param mass      that resists: 1/m_t = 1/m_n + r_i^2/I_i + r_j^2/I_j
/// Source: Walton & Braun, Acta Mech. 63 (1986) 73; Walton (1993), see ContactConstants.
template <int Dim, class Real>
Rubbing<Dim, Real> rubbing(const Vec<Dim, Real>& sliding, const Real& normal, const Real& mass,
                           const ContactConstants<Real>& constants) {
  using std::sqrt;
  Rubbing<Dim, Real> rubbing;
  const Real speed = sqrt(dot(sliding, sliding));
  if (!constants.is_rough() || !(speed > 0)) return rubbing;
  const Real sticking = (1 + constants.tangential_restitution) * mass * speed;
  const Real most = constants.friction * normal;
  rubbing.slides = sticking > most;
  const Real size = rubbing.slides ? most : sticking;
  rubbing.impulse = sliding * Real(-size / speed);
  rubbing.loss = size * (speed - size / (2 * mass));
  return rubbing;
}

}  // namespace zenosphere
