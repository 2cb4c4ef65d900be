#include "flow/reliability.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "flow/standard_error.hpp"
#include "flow/steadiness.hpp"
#include "flow/streaks.hpp"
#include "flow/trend.hpp"

namespace zenosphere {
namespace {

/// The first interval that begins at `time` or later.
std::size_t first_from(const ObservableSeries& series, double time) {
  std::size_t first = 0;
  while (first < series.rows() && series.end_of(first) < time) ++first;
  return first;
}

void add_errors(Averages& averages, const ObservableSeries& series, std::size_t first) {
  double fewest = std::numeric_limits<double>::infinity();
  std::vector<double> errors;
  for (std::size_t number = 0; number < series.width(); ++number) {
    const MeasuredMean measured = measured_mean(series.linearised(number, first));
    errors.push_back(measured.standard_error);
    fewest = std::fmin(fewest, measured.independent);
  }
  averages.standard_error = series.shaped(errors);
  if (std::isfinite(fewest)) averages.blocks = static_cast<std::int64_t>(fewest);
}

/// What is taken at the ends of the intervals has no part in the span after the last of them.
void add_sonine(Averages& averages, const ObservableSeries& series, std::size_t first) {
  if (!series.shape().sonine_a2) return;
  averages.sonine_a2 = first < series.rows() ? series.mean(first, {}, 0).sonine_a2 : std::nan("");
}

void add_streaks(Averages& averages, const ObservableSeries& series, std::size_t first,
                 const Inertia& inertia) {
  if (averages.streak_modes.empty() || first >= series.rows()) return;
  averages.streak_modes = series.mean(first, {}, 0).streak_modes;
  averages.streak_amplitude =
      *std::max_element(averages.streak_modes.begin(), averages.streak_modes.end());
  const auto dimension = static_cast<double>(averages.temperature_diagonal.size());
  averages.temperature_without_streak =
      averages.granular_temperature - streak_temperature(averages, inertia) / dimension;
}

}  // namespace

void add_reliability(Averages& averages, const ObservableSeries& series, const Inertia& inertia) {
  const std::size_t first = first_from(series, averages.from_time);
  add_errors(averages, series, first);
  add_sonine(averages, series, first);
  add_streaks(averages, series, first, inertia);
  const Steadiness found = steadiness(series, first, averages, inertia);
  averages.steady = found.steady;
  averages.steady_reason = found.reason;
}

std::size_t first_steady(const ObservableSeries& series) {
  constexpr std::array<std::string_view, 4> counted{"granular_temperature", "pressure",
                                                    "shear_work", "collision_rate"};
  std::size_t first = 0;
  for (const ObservableColumn& column : series.columns()) {
    if (std::find(counted.begin(), counted.end(), column.name) == counted.end()) continue;
    const auto values = series.values(column);
    if (!are_constant(values)) first = std::max(first, transient_length(values));
  }
  return first;
}

}  // namespace zenosphere
