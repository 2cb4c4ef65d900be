#pragma once

#include <string>
#include <vector>

#include "campaign/axis.hpp"
#include "case/case_template.hpp"

namespace zenosphere {

/// A base case as a text that stands for itself: no comments, no seed, no key of an axis, and
/// absolute names of files.
std::string base_text_of(const CaseTemplate& base, const std::vector<SweepAxis>& axes);

}  // namespace zenosphere
