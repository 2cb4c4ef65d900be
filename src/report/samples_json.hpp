#pragma once

#include "case/case.hpp"
#include "storage/records.hpp"
#include "text/json.hpp"

namespace zenosphere {

/// Curves of what a run has accumulated, for its page: radial distribution, distribution of a
/// velocity component, and profiles, all as in docs/measurements.md, over all of its samples.
///
/// \return null where there are no samples; a number that is not known is NaN, null in a text
Json samples_json(const RecordedSamples& samples, const Case& values);

}  // namespace zenosphere
