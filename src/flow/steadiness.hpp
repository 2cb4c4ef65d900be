#pragma once

#include <optional>
#include <string>

#include "flow/averages.hpp"
#include "flow/observable_series.hpp"
#include "flow/streaks.hpp"

namespace zenosphere {

struct Steadiness {
  std::optional<bool> steady;  ///< none: cannot be told
  std::string reason;          ///< one sentence
};

/// A trend of so many standard errors is a drift. How often one comes by chance:
/// docs/measurements.md.
inline constexpr double drift_in_errors = 5;
/// Streaks that carry more than this share of T_xx, the strongest with more than so many times the
/// thermal energy of a mode, are more than the fluctuations of a sheared gas: a state of its own,
/// which depends on the size of the box. Measured: docs/measurements.md.
inline constexpr double streak_share_limit = 0.025;
inline constexpr double streak_energy_limit = 30;

/// Whether averages are those of a steady state.
///
/// Not steady: the ranks of an average have a trend of more than `drift_in_errors`, or one that
/// explains nearly all of them; or there is a streak beyond both limits. Cannot be told: there are
/// fewer than 16 intervals, or an average wanders so slowly that they are worth fewer than 4
/// independent values.
///
/// \param first     interval from which on the averages were taken
/// \param averages  with their streaks
Steadiness steadiness(const ObservableSeries& series, std::size_t first, const Averages& averages,
                      const Inertia& inertia);

}  // namespace zenosphere
