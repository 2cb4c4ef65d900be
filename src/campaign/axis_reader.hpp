#pragma once

#include <vector>

#include "campaign/axis.hpp"
#include "case/case_tree.hpp"

namespace zenosphere {

/// The axes that the table [axes] of a sweep file describes.
///
/// Each key of it is a key of the case, quoted or in tables of its own; its value an array, or a
/// range { from, to, points, spacing }. What is wrong becomes a problem.
std::vector<SweepAxis> axes_of(const case_format::TreeNode& table, case_format::Problems& problems);

}  // namespace zenosphere
