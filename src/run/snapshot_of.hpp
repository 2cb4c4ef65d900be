#pragma once

#include "engine/simulation.hpp"
#include "storage/records.hpp"

namespace zenosphere {

/// The whole system as it is now, in laboratory coordinates and rounded to `double`.
template <int Dim, class Real>
Snapshot snapshot_of(const Simulation<Dim, Real>& simulation);

/// Velocities relative to the imposed profile: N x D, row-major, diameters/time.
template <int Dim, class Real>
std::vector<double> peculiar_velocities_of(const Simulation<Dim, Real>& simulation);

}  // namespace zenosphere
