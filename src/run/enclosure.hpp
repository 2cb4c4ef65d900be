#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "case/case.hpp"
#include "proof/certificate.hpp"
#include "result/adjudication.hpp"
#include "run/cluster_gaps.hpp"

namespace zenosphere {

/// The collision of a trial from which an approach can be enclosed: its median gap is below 1e-10,
/// so that little time is left in which another sphere could come. Nothing where the approach is of
/// no kind to be enclosed: it must have used up its digits, as one that is singular or undecided.
///
/// \param values  the case: smooth discs or spheres that are mobile, in a box or in shear, without
///                walls, gravity, kicks or contact models
std::optional<std::int64_t> place_to_enclose(const Case& values, const JudgedApproach& approach);

/// What is certain of a cluster from one state of a trial on, by ball arithmetic.
///
/// The numbers of the state are taken as exact. Nothing where that cannot be said of the cluster
/// alone: another sphere may reach it before the last contact enclosed, or it closes around the
/// box.
///
/// \param decades  of gap, at which it is enough
template <int Dim, class Real>
std::optional<Certificate> enclosed(const Case& values, const ClusterGaps<Dim, Real>& state,
                                    const std::vector<std::int32_t>& cluster, int decades,
                                    std::chrono::steady_clock::time_point deadline,
                                    const std::atomic<bool>* interrupt);

/// Writes it into the approach, which it may turn into a near-collapse: the spheres certainly part.
///
/// \param collision  of the trial, at whose state it began
void tell_enclosure(const Certificate& certificate, std::int64_t collision,
                    JudgedApproach& approach);

}  // namespace zenosphere
