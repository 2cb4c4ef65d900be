#pragma once

#include "flow/averages.hpp"
#include "flow/observable_series.hpp"
#include "flow/streaks.hpp"

namespace zenosphere {

/// Adds to averages what the series of the run tells about them: their standard errors, whether
/// they are those of a steady state, and what streaks have to do with them.
///
/// \param series   of the run; the intervals that lie in the averaged time as a whole count
void add_reliability(Averages& averages, const ObservableSeries& series, const Inertia& inertia);

/// The first interval of the steady state: from there on the means of temperature, pressure, shear
/// stress and collision rate are known best (see transient_length). The last of these four counts.
std::size_t first_steady(const ObservableSeries& series);

}  // namespace zenosphere
