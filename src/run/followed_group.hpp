#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collapse/approach.hpp"
#include "collapse/contact_word.hpp"
#include "collapse/finding.hpp"
#include "result/adjudication.hpp"
#include "run/hit_groups.hpp"
#include "run/kept_collisions.hpp"

namespace zenosphere {

/// An approach as one trial has seen it.
struct SeenApproach {
  ApproachEvidence evidence;
  std::vector<std::int32_t> spheres{};
  double begin_depth = 0;  ///< decades of its smallest gap where the trial began; 0 at the start
  std::vector<std::size_t> places{};  ///< of the cluster's rows among all rows of the trial
  std::int64_t first_collision = 0;   ///< as in JudgedApproach
  std::string first_time{};
  std::vector<Milestone> milestones{};
  std::optional<std::string> collapse_time{};
  std::optional<double> uncertainty{};
};

/// The state from which a trial went on.
struct TrialBegin {
  std::int64_t collisions = 0;
  double depth = 0;  ///< decades of the smallest gap of the group's spheres; 0 at the start
};

/// What one trial has seen of a group of hits.
struct FollowedGroup {
  Trial trial;
  double limit = 0;  ///< decades of the type's resolution
  TrialBegin begin{};
  std::int64_t first_number = 0;     ///< of the first row
  std::vector<DepthRow> rows{};      ///< every collision of the trial
  std::vector<SeenApproach> seen{};  ///< in order of their first rows
};

/// The approaches of a group's spheres among the collisions of a trial, in order.
///
/// \param limit    decades of the type's resolution
/// \param spheres  of the system
template <class Real>
std::vector<SeenApproach> approaches_seen(const KeptCollisions<Real>& collisions, double limit,
                                          std::int32_t spheres, const HitGroup& group);

}  // namespace zenosphere
