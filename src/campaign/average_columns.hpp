#pragma once

#include <optional>
#include <vector>

#include "campaign/run_columns.hpp"

namespace zenosphere {

/// Adds the columns of the averages of a run: each of `Observables` with its standard error, and
/// how far they can be trusted. Rows and matrices are JSON; what a run does not have is NULL.
void add_average_columns(const std::optional<Averages>& averages,
                         std::vector<ResultColumn>& columns);

}  // namespace zenosphere
