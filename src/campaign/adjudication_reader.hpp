#pragma once

#include "campaign/adjudication_request.hpp"
#include "case/case_problems.hpp"
#include "case/case_tree.hpp"

namespace zenosphere {

/// What the table [adjudicate] of a sweep file asks for; what is wrong with it becomes problems.
AdjudicationRequest adjudication_of(const case_format::TreeNode& table,
                                    case_format::Problems& problems);

}  // namespace zenosphere
