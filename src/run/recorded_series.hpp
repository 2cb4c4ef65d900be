#pragma once

#include "flow/observable_series.hpp"
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

}  // namespace zenosphere
