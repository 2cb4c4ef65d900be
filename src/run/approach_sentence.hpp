#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "collapse/finding.hpp"
#include "io/adjudication.hpp"

namespace zenosphere {

/// Decades as they are told: never more than there are.
inline int whole(double decades) { return static_cast<int>(std::floor(decades)); }

/// The numbers of the first few spheres: "3-7-12-...".
std::string names_of(const std::vector<std::int32_t>& spheres);

/// What has been found about an approach, with the evidence, from all else that `judged` holds.
std::string sentence_of(const JudgedApproach& judged, const ApproachEvidence& evidence);

}  // namespace zenosphere
