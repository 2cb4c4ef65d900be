#pragma once

#include <vector>

#include "campaign/run_columns.hpp"

namespace zenosphere {

/// The columns of the averages of a run: each of `Observables` with its standard error, and how far
/// they can be trusted. Rows and matrices are JSON; what a run does not have is NULL.
std::vector<ResultColumn> average_columns();

}  // namespace zenosphere
