#pragma once

#include <cstdint>

#include "engine/system.hpp"

/// Whether spheres that have long met no other will ever do so again.
namespace zenosphere {

/// Spheres of which all pairs can be looked at.
inline constexpr std::int32_t most_in_pairs = 1000;

/// Whether nothing is left of the relative velocities but what rounding makes of equal ones.
template <int Dim, class Real>
bool move_as_one(const System<Dim, Real>& system);

/// The largest component, along the axes along which the frame may move, of the velocities relative
/// to the given one.
template <int Dim, class Real>
Real fastest_beside(const System<Dim, Real>& system, const Vec<Dim, Real>& velocity);

/// Whether it is certain that no sphere ever meets another one or a wall: of spheres that fly
/// straight. False where they are more than most_in_pairs.
template <int Dim, class Real>
bool never_meet(const System<Dim, Real>& system);

/// Whether it is certain that no two unit spheres meet within some time, in a sheared box.
template <int Dim, class Real>
bool stay_apart_sheared(const System<Dim, Real>& system, double time);

/// Time for which certainly no two spheres meet that are alone, as far as that can be foreseen: of
/// a time below `least` only that it is. For unit spheres without shear in an upright grid of
/// boxes.
///
/// \param most  no more is asked for
template <int Dim, class Real>
Real certainly_apart(const System<Dim, Real>& system, const Real& most, const Real& least);

}  // namespace zenosphere
