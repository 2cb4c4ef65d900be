#include "flow/observable_series.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

namespace zenosphere {
namespace {

std::span<const double> numbers_of(const double& number) { return {&number, 1}; }
std::span<const double> numbers_of(const std::vector<double>& numbers) { return numbers; }
std::span<const double> numbers_of(const std::optional<double>& number) {
  return {number ? &*number : nullptr, number ? 1u : 0u};
}
std::span<double> numbers_of(std::optional<double>& number) {
  return {number ? &*number : nullptr, number ? 1u : 0u};
}
std::span<double> numbers_of(double& number) { return {&number, 1}; }
std::span<double> numbers_of(std::vector<double>& numbers) { return numbers; }

/// An average without what it was divided by. Where that is 0 there is nothing to add.
double with_weight(double average, Mean mean, double weight) {
  if (mean == Mean::of_squares) return average * average;
  if (mean == Mean::over_time) return average;
  return weight > 0 ? average * weight : 0;
}

double without_weight(double sum, Mean mean, double weight) {
  if (mean == Mean::of_squares) return std::sqrt(sum);
  return mean == Mean::over_time ? sum : sum / weight;
}

}  // namespace

ObservableSeries::ObservableSeries(const Observables& prototype, double interval,
                                   std::int64_t spheres)
    : prototype_(prototype), spheres_(spheres), interval_(interval) {
  Observables::fields(prototype_,
                      [&](const char* name, const auto& member, Shape shape, Mean mean) {
                        const std::size_t count = numbers_of(member).size();
                        columns_.push_back({name, shape, mean, width_, count});
                        if (columns_.back().name == "collision_rate") collision_rate_ = width_;
                        if (columns_.back().name == "granular_temperature")
                          granular_temperature_ = width_;
                        if (columns_.back().name == "pressure") pressure_ = width_;
                        means_.insert(means_.end(), count, mean);
                        width_ += count;
                      });
}

double ObservableSeries::weight_of(Mean mean, const double* row) const {
  if (mean == Mean::over_collisions) return row[collision_rate_];
  if (mean == Mean::over_thermal) return row[granular_temperature_];
  if (mean == Mean::over_pressure) return row[pressure_];
  return 1;
}

void ObservableSeries::add(const Observables& averages, std::int64_t step) {
  std::vector<double> row;
  row.reserve(width_);
  Observables::fields(averages, [&](const char*, const auto& member, Shape, Mean) {
    for (const double number : numbers_of(member)) row.push_back(number);
  });
  assert(row.size() == width_);
  const std::vector<double> numbers = row;
  for (std::size_t k = 0; k < width_; ++k) {
    row[k] = with_weight(numbers[k], means_[k], weight_of(means_[k], numbers.data()));
  }
  sums_.insert(sums_.end(), row.begin(), row.end());
  steps_.push_back(step);
  put_together();
}

/// Doubles the interval where there are too many of them.
void ObservableSeries::put_together() {
  constexpr std::size_t few = 32;  // cost nothing
  const auto many = [&] {
    const bool is_dense = static_cast<std::int64_t>(rows()) * spheres_ > steps_.back();
    return rows() >= most_rows || (rows() >= few && is_dense);
  };
  while (rows() % 2 == 0 && many()) {
    const std::size_t half = rows() / 2;
    for (std::size_t row = 0; row < half; ++row) {
      steps_[row] = steps_[2 * row + 1];
      for (std::size_t k = 0; k < width_; ++k) {
        const double sum = sums_[2 * row * width_ + k] + sums_[(2 * row + 1) * width_ + k];
        sums_[row * width_ + k] = sum / 2;
      }
    }
    steps_.resize(half);
    sums_.resize(half * width_);
    interval_ *= 2;
  }
}

std::vector<double> ObservableSeries::values(const ObservableColumn& column,
                                             std::size_t first) const {
  std::vector<double> values;
  values.reserve((rows() - first) * column.count);
  for (std::size_t row = first; row < rows(); ++row) {
    const double* const sums = &sums_[row * width_];
    const double weight = weight_of(column.mean, sums);
    for (std::size_t k = 0; k < column.count; ++k) {
      values.push_back(without_weight(sums[column.first + k], column.mean, weight));
    }
  }
  return values;
}

Observables ObservableSeries::mean(std::size_t first, const Observables& after, double span) const {
  std::vector<double> total(width_, 0.0);
  double time = 0;
  const auto add_span = [&](const double* sums, double duration) {
    time += duration;
    for (std::size_t k = 0; k < width_; ++k) total[k] += sums[k] * duration;
  };
  for (std::size_t row = first; row < rows(); ++row) add_span(&sums_[row * width_], interval_);
  if (span > 0) {
    ObservableSeries last(prototype_, span, spheres_);
    last.add(after, 0);
    add_span(last.sums_.data(), span);
  }
  for (double& sum : total) sum /= time;
  std::vector<double> row(width_);
  for (std::size_t k = 0; k < width_; ++k) {
    row[k] = without_weight(total[k], means_[k], weight_of(means_[k], total.data()));
  }
  return shaped(row);
}

std::vector<double> ObservableSeries::linearised(std::size_t number, std::size_t first) const {
  const Mean mean = means_.at(number);
  const auto length = static_cast<double>(rows() - first);
  double sum = 0, weights = 0;
  for (std::size_t row = first; row < rows(); ++row) {
    sum += sums_[row * width_ + number] / length;
    weights += weight_of(mean, &sums_[row * width_]) / length;
  }
  const double average = without_weight(sum, mean, weights);
  std::vector<double> series;
  series.reserve(rows() - first);
  for (std::size_t row = first; row < rows(); ++row) {
    const double own = sums_[row * width_ + number];
    const double weight = weight_of(mean, &sums_[row * width_]);
    if (mean == Mean::of_squares) {
      series.push_back(average > 0 ? average + (own - sum) / (2 * average) : 0);
    } else {
      series.push_back(average + (own - average * weight) / weights);
    }
  }
  return series;
}

Observables ObservableSeries::shaped(const std::vector<double>& row) const {
  Observables result = prototype_;
  auto next = row.begin();
  Observables::fields(result, [&](const char*, auto& member, Shape, Mean) {
    for (double& number : numbers_of(member)) number = *next++;
  });
  return result;
}

}  // namespace zenosphere
