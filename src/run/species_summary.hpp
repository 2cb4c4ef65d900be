#pragma once

#include <optional>
#include <vector>

#include "case/case.hpp"
#include "flow/averages.hpp"
#include "result/summary.hpp"

namespace zenosphere {

/// The species of a case with the temperatures that they had in the mean; empty without any.
std::vector<Summary::Kind> species_summary(const Case& values,
                                           const std::optional<Averages>& averages);

}  // namespace zenosphere
