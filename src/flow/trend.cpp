#include "flow/trend.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "flow/standard_error.hpp"

namespace zenosphere {

Trend trend(std::span<const double> values) {
  const auto length = static_cast<double>(values.size());
  const double middle = (length - 1) / 2;
  double mean = 0, moment = 0, squares = 0;
  for (const double value : values) mean += value / length;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double place = static_cast<double>(k) - middle;
    moment += place * (values[k] - mean);
    squares += place * place;
  }
  const double slope = moment / squares;
  std::vector<double> rest;
  double scatter = 0, variance = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double deviation = values[k] - mean;
    rest.push_back(deviation - slope * (static_cast<double>(k) - middle));
    scatter += rest.back() * rest.back();
    variance += deviation * deviation;
  }
  const double rounding = 1e-24 * variance;
  const double inefficiency = scatter > rounding ? statistical_inefficiency(rest) : 1;
  return {slope * length, length * std::sqrt(scatter / (length - 2) * inefficiency / squares),
          variance > 0 ? 1 - scatter / variance : 0};
}

std::vector<double> ranks(std::span<const double> values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> ranks(values.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    ranks[order[rank]] = static_cast<double>(rank);
  }
  return ranks;
}

std::size_t transient_length(std::span<const double> values) {
  constexpr std::size_t batch = 5;
  const std::size_t batches = values.size() / batch;
  double least = std::numeric_limits<double>::infinity();
  std::size_t dropped = 0;
  double count = 0, mean = 0, squares = 0;  // of the batches from `begin` on, by Welford's updates
  for (std::size_t begin = batches; begin-- > 0;) {
    double sum = 0;
    for (std::size_t k = 0; k < batch; ++k) sum += values[begin * batch + k] / batch;
    ++count;
    const double deviation = sum - mean;
    mean += deviation / count;
    squares += deviation * (sum - mean);
    if (2 * begin > batches) continue;
    const double variance_of_mean = squares / (count * count);
    if (variance_of_mean > least) continue;
    least = variance_of_mean;
    dropped = begin * batch;
  }
  return dropped;
}

}  // namespace zenosphere
