#pragma once

#include <string>

#include "campaign/campaign.hpp"
#include "campaign/estimate.hpp"
#include "campaign/sweep.hpp"

namespace zenosphere {

/// One line that tells how far a sweep is: runs done, running, failed, and the time that remains;
/// on a narrow terminal not all of that.
std::string sweep_line(const SweepProgress& progress, std::size_t columns);

/// How a sweep ended, for people and as one JSON object.
std::string progress_text(const SweepProgress& progress, const std::string& store);
std::string progress_json(const SweepProgress& progress, const std::string& store);

/// What a sweep would do with so many workers (`kind`: threads or ranks), for people and as one
/// JSON object.
std::string plan_text(const Sweep& sweep, const SweepPlan& plan, std::size_t workers,
                      const std::string& kind);
std::string plan_json(const Sweep& sweep, const SweepPlan& plan, std::size_t workers);

}  // namespace zenosphere
