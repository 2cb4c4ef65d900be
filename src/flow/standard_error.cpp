#include "flow/standard_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace zenosphere {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double sum_of_products(std::span<const double> values, std::size_t lag) {
  double sum = 0;
  for (std::size_t k = lag; k < values.size(); ++k) sum += values[k] * values[k - lag];
  return sum;
}

}  // namespace

bool are_constant(std::span<const double> values) {
  constexpr double rounding = 1e-10;  // of a sum over 1e6 flights, with room
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return values.empty() || *most - *least <= rounding * std::max(std::abs(*least), std::abs(*most));
}

double statistical_inefficiency(std::span<const double> deviations) {
  constexpr double window = 4;  // in tau: Sokal's compromise of bias and noise
  const double variance = sum_of_products(deviations, 0);
  if (deviations.size() < 4 || !(variance > 0)) return unknown;
  const auto length = static_cast<double>(deviations.size());
  double time = 0.5;
  for (std::size_t lag = 1; lag < deviations.size(); ++lag) {
    time += sum_of_products(deviations, lag) / variance;
    if (static_cast<double>(lag) < window * std::max(time, 0.5)) continue;
    return std::max(2 * time, 1.0) * (1 + (2 * static_cast<double>(lag) + 1) / length);
  }
  return unknown;
}

MeasuredMean measured_mean(std::span<const double> values) {
  if (values.empty()) return {unknown, unknown, unknown};
  const auto length = static_cast<double>(values.size());
  double mean = 0;
  for (const double value : values) mean += value / length;
  if (values.size() < fewest_values) return {mean, unknown, unknown};
  if (are_constant(values)) return {mean, 0, length};
  std::vector<double> deviations(values.begin(), values.end());
  for (double& deviation : deviations) deviation -= mean;
  const double independent = length / statistical_inefficiency(deviations);
  if (!(independent >= fewest_independent)) return {mean, unknown, independent};
  const double variance = sum_of_products(deviations, 0) / (length - 1);
  return {mean, std::sqrt(variance / independent), independent};
}

}  // namespace zenosphere
