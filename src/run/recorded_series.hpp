#pragma once

#include "flow/observable_series.hpp"
#include "flow/samples.hpp"
#include "storage/records.hpp"

namespace zenosphere {

/// The series of a run as files have it.
inline RecordedSeries recorded(const ObservableSeries& series, int dimension) {
  RecordedSeries recorded{.step = series.steps()};
  for (std::size_t rows = 1; rows <= series.rows(); ++rows) {
    recorded.time.push_back(series.end_of(rows));
  }
  for (const ObservableColumn& column : series.columns()) {
    if (column.count == 0) continue;
    std::vector<std::int64_t> shape;
    if (column.shape == Shape::row) shape = {static_cast<std::int64_t>(column.count)};
    if (column.shape == Shape::matrix) shape = {dimension, dimension};
    recorded.columns.push_back({column.name, std::move(shape), series.values(column)});
  }
  return recorded;
}

/// What a run has accumulated, as files have it.
template <int Dim, class Real>
RecordedSamples recorded(const Samples<Dim, Real>& samples) {
  RecordedSamples recorded{.sums = {.step = samples.steps(), .time = samples.times()}};
  for (std::size_t n = 0; n < samples.columns().size(); ++n) {
    const SampledColumn& column = samples.columns()[n];
    std::vector<std::int64_t> shape(column.shape.begin(), column.shape.end());
    recorded.sums.columns.push_back({column.name, std::move(shape), samples.values(n)});
  }
  for (SampledEdges& edges : samples.edges()) {
    recorded.edges.push_back({std::move(edges.name), {}, std::move(edges.values)});
  }
  return recorded;
}

}  // namespace zenosphere
