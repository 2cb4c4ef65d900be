#pragma once

#include <optional>

#include "case/case.hpp"
#include "engine/simulation.hpp"
#include "storage/output_datasets.hpp"

namespace zenosphere {

/// The spheres of a case at its start, made, written in the case or read from a file.
///
/// What is made is made in `double` and is the same state in every precision; what is written in
/// decimals is read in the precision of Real.
///
/// \param box  that of the case
/// Throws InputError where the start cannot be made.
template <int Dim, class Real>
Configuration<Dim, Real> start_of(const Case& values, const ShearBox<Dim, Real>& box);

/// The rules of contact of a case, contact models included.
template <class Real>
ContactRules<Real> contact_rules_of(const Case& values);

/// Gravity and walls of a case.
template <int Dim, class Real>
Surroundings<Dim, Real> surroundings_of(const Case& values);

/// The simulation of a case at its start.
///
/// Throws InputError where the start cannot be made.
template <int Dim, class Real>
Simulation<Dim, Real> new_simulation(const Case& values);

/// The simulation of a case in the state that an archive holds.
///
/// Throws ArchiveError where that state cannot be.
template <int Dim, class Real>
Simulation<Dim, Real> archived_simulation(const Case& values, ArchiveReader& archive);

/// The restitution of spheres, if it is the same in every collision.
std::optional<double> constant_restitution(const Case& values);

/// What the output of a case says about it.
OutputHeader output_header(const Case& values);

}  // namespace zenosphere
