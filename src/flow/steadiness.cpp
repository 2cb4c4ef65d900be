#include "flow/steadiness.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string_view>
#include <vector>

#include "flow/standard_error.hpp"
#include "flow/streaks.hpp"
#include "flow/trend.hpp"

namespace zenosphere {
namespace {

constexpr std::size_t fewest_intervals = 16;
constexpr double fewest_independent_of_steady = 4;
/// How far the first sixteenth may be from the others, in standard deviations of these: ranks do
/// not see a burst at the start. Of stationary series it is a matter of 1e-6.
constexpr double transient_in_deviations = 8;

/// A number as people read it: four digits.
std::string text_of(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", number);
  return text;
}

/// `pressure tensor xy`, for a component of an observable.
std::string label(const ObservableColumn& column, std::size_t component, std::size_t dimension) {
  constexpr std::string_view axes = "xyz";
  std::string name = column.name;
  std::replace(name.begin(), name.end(), '_', ' ');
  if (column.shape == Shape::matrix) {
    return name + ' ' + axes[component / dimension] + axes[component % dimension];
  }
  if (name == "temperature diagonal") return std::string("temperature along ") + axes[component];
  if (name == "normal stress differences") {
    return "normal stress difference N" + std::to_string(component + 1);
  }
  return column.count > 1 ? name + ' ' + std::to_string(component) : name;
}

/// The numbers of a row that are no streak: these remember for longer than any average.
template <class Action>
void for_each_average(const ObservableSeries& series, Action action) {
  for (const ObservableColumn& column : series.columns()) {
    if (column.mean == Mean::of_squares) continue;
    for (std::size_t k = 0; k < column.count; ++k) action(column, k);
  }
}

/// What is furthest from being steady.
struct Worst {
  double drift = 0;  ///< trend over its error
  std::string drifting;
  double values = fewest_independent_of_steady;
  std::string wandering;
  double start = transient_in_deviations;  ///< how far the beginning is from the rest
  std::string starting;
};

/// `pressure rises from 0.5 to 0.6`: the means of the first and of the last fifth.
std::string drift_text(const std::string& name, const std::vector<double>& values) {
  const auto fifth = static_cast<std::ptrdiff_t>(std::max<std::size_t>(values.size() / 5, 1));
  const auto mean = [&](auto begin) {
    return std::accumulate(begin, begin + fifth, 0.0) / static_cast<double>(fifth);
  };
  const double first = mean(values.begin()), last = mean(values.end() - fifth);
  return name + (last > first ? " rises from " : " falls from ") + text_of(first) + " to " +
         text_of(last);
}

/// The mean of the first sixteenth and that of the others.
struct Beginning {
  double mean;
  double mean_of_rest;
  double deviations;  ///< between them, in standard deviations of a sixteenth
};

Beginning beginning(const std::vector<double>& values) {
  constexpr std::size_t parts = fewest_intervals;
  const auto length = static_cast<std::ptrdiff_t>(values.size() / parts);
  const auto mean = [&](std::size_t part) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(part) * length;
    return std::accumulate(begin, begin + length, 0.0) / static_cast<double>(length);
  };
  double sum = 0, squares = 0;
  for (std::size_t part = 1; part < parts; ++part) sum += mean(part);
  const double of_rest = sum / (parts - 1);
  for (std::size_t part = 1; part < parts; ++part) {
    squares += (mean(part) - of_rest) * (mean(part) - of_rest);
  }
  const double deviation = std::sqrt(squares / (parts - 2));
  return {mean(0), of_rest, std::abs(mean(0) - of_rest) / deviation};
}

Worst worst_of(const ObservableSeries& series, std::size_t first, std::size_t dimension) {
  constexpr double most = 0.75;  // of the variance: then the trend is what there is
  Worst worst;
  for_each_average(series, [&](const ObservableColumn& column, std::size_t k) {
    const auto values = series.linearised(column.first + k, first);
    if (are_constant(values)) return;
    const MeasuredMean measured = measured_mean(values);
    const Trend order = trend(ranks(values));
    const bool is_trend_only =
        !(measured.independent >= fewest_independent_of_steady) && order.explained > most;
    const double errors = std::abs(order.change) / order.error;
    const double drift = is_trend_only ? std::fmax(errors, drift_in_errors + 1) : errors;
    if (drift > std::max(worst.drift, drift_in_errors)) {
      worst.drift = drift;
      worst.drifting = drift_text(label(column, k, dimension), values);
    }
    const Beginning start = beginning(values);
    if (start.deviations > worst.start) {
      worst.start = start.deviations;
      worst.starting = label(column, k, dimension) + " begins at " + text_of(start.mean) +
                       " and is " + text_of(start.mean_of_rest) + " afterwards";
    }
    const double independent = std::isnan(measured.independent) ? 1 : measured.independent;
    if (independent < worst.values) {
      worst.values = independent;
      worst.wandering = label(column, k, dimension);
    }
  });
  return worst;
}

std::string span_text(const Averages& averages) {
  return "from time " + text_of(averages.from_time) + " to " + text_of(averages.to_time);
}

std::string streak_text(const Averages& averages, double share) {
  return "a streak along the flow carries " + text_of(std::round(100 * share)) +
         " % of T_xx (granular temperature " + text_of(averages.granular_temperature) +
         ", without it " + text_of(averages.temperature_without_streak.value_or(0)) + ")";
}

}  // namespace

Steadiness steadiness(const ObservableSeries& series, std::size_t first, const Averages& averages,
                      const Inertia& inertia) {
  const std::size_t intervals = series.rows() - first;
  const bool is_long = intervals >= fewest_intervals;
  const double along_flow = averages.temperature_diagonal[0];
  const double share = streak_temperature(averages, inertia) / along_flow;
  const double amplitude = averages.streak_amplitude.value_or(0);
  const double thermal =
      4 * along_flow / (inertia.spheres * inertia.mean_mass);  // mean square of it
  const bool has_streak =
      share > streak_share_limit && amplitude * amplitude > streak_energy_limit * thermal;
  const Worst worst =
      is_long ? worst_of(series, first, averages.temperature_diagonal.size()) : Worst{};
  if (!worst.drifting.empty()) {
    return {false, "not steady: " + worst.drifting + ' ' + span_text(averages) +
                       (has_streak ? "; " + streak_text(averages, share) : "")};
  }
  if (!worst.starting.empty()) {
    return {false, "not steady: " + worst.starting + ", " + span_text(averages) +
                       "; leave out the beginning (measure.after_time)"};
  }
  if (has_streak) return {false, "not steady: " + streak_text(averages, share)};
  if (!is_long) {
    return {std::nullopt, "too short to tell: " + std::to_string(intervals) + " intervals " +
                              span_text(averages) + ", " + std::to_string(fewest_intervals) +
                              " are needed; raise run.time, or lower measure.interval"};
  }
  if (!worst.wandering.empty()) {
    return {std::nullopt, "too short to tell: " + worst.wandering + " wanders " +
                              span_text(averages) + " as if there were " +
                              text_of(std::floor(worst.values)) +
                              " independent values; raise run.time"};
  }
  return {true, "steady " + span_text(averages) + ": no average drifts by more than " +
                    text_of(drift_in_errors) + " standard errors of its trend"};
}

}  // namespace zenosphere
