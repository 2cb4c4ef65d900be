#pragma once

#include <cstdint>

#include "model/clock.hpp"
#include "model/contact.hpp"

namespace zenosphere {

/// One collision as it was done: all that leaves the event loop.
template <int Dim, class Real>
struct Collision {
  std::int64_t number = 0;  ///< 1 for the first collision of the run
  Instant<Real> time;
  Real flight = 0;  ///< time since the collision before (since the start); <= 0 by rounding
  std::int32_t i = 0;
  std::int32_t j = 0;  ///< > i; the number of spheres and one more stand for the two walls
  Impact<Dim, Real> impact;
  Vec<Dim, Real> change;  ///< of the momentum of i, mass diameter/time; that of a sphere j is the
                          ///< opposite. Along the normal unless the contact is rough or a contact
                          ///< model has turned it
  Real gap_before = 0;    ///< that this pair had to close after the collision before (or the kick,
                          ///< if one came since); off a wall and back to it: the height of the apex
  Vec<Dim, Real> friction;    ///< of that the part across the normal that friction has made
  Real friction_loss = 0;     ///< energy that friction took, mass diameter^2/time^2
  bool overlapping = false;   ///< the overlap rule gave the time
  bool absorbed = false;      ///< no bit of any velocity or spin has changed
  bool made_elastic = false;  ///< by the TC model
  bool sliding = false;       ///< friction was at its limit: the surfaces slid
  bool resting = false;       ///< of a sphere that rests on an oscillating wall
};

}  // namespace zenosphere
