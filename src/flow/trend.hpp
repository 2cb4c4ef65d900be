#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace zenosphere {

/// The straight line through a series.
struct Trend {
  double change;     ///< along the line, from the begin of the series to its end
  double error;      ///< its standard error, from the scatter about the line; NaN where unknown
  double explained;  ///< share of the variance that the line explains
};

/// Fits a line to equally spaced values of a correlated series, at least 3.
///
/// The error takes the correlations of what is left beside the line into account; else a slow
/// fluctuation would look like a trend.
Trend trend(std::span<const double> values);

/// The place of each value in their order of size, from 0 on: a trend of these is one of the
/// values, whatever its form, and no outlier makes one.
std::vector<double> ranks(std::span<const double> values);

/// Where a series becomes stationary: how many values are to be dropped from its begin, so that the
/// mean of the rest is known best. At most half of them.
///
/// Values are taken in batches of 5; the rest begins where the variance of its batches over their
/// number is least.
///
/// Source: White, Simulation 69 (1997) 323; in batches (MSER-5): White, Cobb & Spratt, Proc. 2000
/// Winter Simulation Conf., 755.
std::size_t transient_length(std::span<const double> values);

}  // namespace zenosphere
