#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

#include "io/adjudication.hpp"
#include "io/case.hpp"

namespace zenosphere {

/// How much a trial may cost.
struct AdjudicationLimits {
  Precision highest = Precision::digits100;
  std::int64_t collisions = 20000;  ///< of each trial, after the run's first hit
  const std::atomic<bool>* interrupt = nullptr;
  std::function<void(const std::string&)> on_trial{};  ///< called before each, with its name
};

/// Physics or rounding? Goes back to a state before the first separation hit of a run, and goes on
/// from there in every precision from the run's own upwards and under every overlap rule.
///
/// The run is done again from its start up to two collisions a sphere before the hit: close enough
/// for all precisions to meet the same hit before chaos parts them. That state is promoted: its
/// numbers are the same in more digits.
///
/// Throws InputError where the run has no separation hit within the limits of its case.
Adjudication adjudicate(const Case& values, const AdjudicationLimits& limits);

}  // namespace zenosphere
