#pragma once

#include <optional>
#include <vector>

#include "campaign/axis.hpp"
#include "campaign/boundary_request.hpp"
#include "case/case_problems.hpp"
#include "case/case_tree.hpp"

namespace zenosphere {

/// The search that the table [boundary] of a sweep file describes; its axis is added to the others.
/// What is wrong becomes a problem, and there is no search then.
std::optional<BoundaryRequest> boundary_of(const case_format::TreeNode& table,
                                           std::vector<SweepAxis>& axes,
                                           case_format::Problems& problems);

}  // namespace zenosphere
