#pragma once

#include <cstddef>
#include <span>

namespace zenosphere {

/// The mean of a correlated stationary series, and how well it is known.
struct MeasuredMean {
  double mean;
  double standard_error;  ///< NaN where the series is too short to tell
  double independent;     ///< values that it is worth: its length / (2 tau); NaN where unknown
};

/// Fewest independent values whose scatter gives an error.
inline constexpr double fewest_independent = 6;
/// Fewest values, however independent they look.
inline constexpr std::size_t fewest_values = 16;

/// Mean and standard error of the mean of equally spaced values.
///
/// tau is the integrated autocorrelation time, summed up to a lag of 4 tau; what the mean of a
/// finite series takes off it is put back. A series whose values differ by rounding only (a
/// conserved quantity) has the error 0. The error is NaN for a series of fewer than
/// `fewest_values`, or worth fewer than `fewest_independent`.
///
/// Source of the window: Madras & Sokal, J. Stat. Phys. 50 (1988) 109, app. C; of the correction:
/// Wolff, Comput. Phys. Commun. 156 (2004) 143, eq. 49.
MeasuredMean measured_mean(std::span<const double> values);

/// Twice the integrated autocorrelation time: how many values are worth one that is independent.
/// At least 1; NaN for fewer than 4 values or where the sum reaches the end of the series.
///
/// \param deviations  from the mean, or from a line
double statistical_inefficiency(std::span<const double> deviations);

/// Whether the values differ by rounding only.
bool are_constant(std::span<const double> values);

}  // namespace zenosphere
