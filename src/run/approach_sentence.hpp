#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "collapse/finding.hpp"
#include "result/adjudication.hpp"

namespace zenosphere {

/// Decades as they are told: never more than there are.
inline int whole(double decades) { return static_cast<int>(std::floor(decades)); }

/// How many spheres, and the numbers of the first few: "9 spheres (3-7-12-15-18-21-...)".
///
/// \param one  what one of them is called
std::string count_and_names(const std::vector<std::int32_t>& spheres,
                            std::string_view one = "sphere");

/// What has been found about an approach, with the evidence, from all else that `judged` holds.
std::string sentence_of(const JudgedApproach& judged, const ApproachEvidence& evidence);

}  // namespace zenosphere
