#include "storage/series_group.hpp"

#include <algorithm>
#include <string>

#include "flow/averages.hpp"
#include "storage/hdf5_contents.hpp"
#include "storage/hdf5_series.hpp"

namespace zenosphere {
namespace {

using hdf5::Handle;
using hdf5::Series;
using hdf5::Type;

constexpr std::int64_t rows_per_chunk = 64;

Handle group_at(const Handle& parent, const std::string& name) {
  return hdf5::contains(parent, name) ? hdf5::opened(parent, name)
                                      : hdf5::created_group(parent, name);
}

template <class T>
void put(const Handle& group, const std::string& name, const std::vector<std::int64_t>& row_shape,
         const std::vector<T>& values) {
  const Type type = hdf5::type_of<T>;
  if (hdf5::contains(group, name)) {
    Series(group, name, type).replace(values);
  } else {
    Series(group, name, type, row_shape, rows_per_chunk).append(values);
  }
}

/// An element as H5MD has them: values with the step and the time of each.
///
/// \param folder  the group in `parent` that the element is in
/// \param clock   where these are in `parent`
void put_element(const Handle& parent, const std::string& folder, const std::string& clock,
                 const RecordedSeries::Column& column, const std::vector<double>& values) {
  const Handle element = group_at(hdf5::opened(parent, folder), column.name);
  put(element, "value", column.shape, values);
  for (const std::string name : {"step", "time"}) {
    if (hdf5::contains(element, name)) continue;
    hdf5::link(parent, clock + '/' + name, folder + '/' + column.name + '/' + name);
  }
}

/// For each snapshot the row of the interval in which it lies.
std::vector<std::size_t> rows_at(const std::vector<double>& times, const RecordedSeries& series) {
  std::vector<std::size_t> rows;
  for (const double time : times) {
    const auto end = std::upper_bound(series.time.begin(), series.time.end(), time);
    const auto row = static_cast<std::size_t>(end - series.time.begin());
    rows.push_back(std::min(row, series.time.size() - 1));
  }
  return rows;
}

void write_observables(const Handle& file, const RecordedSeries& series) {
  const auto times = hdf5::values<double>(file, "particles/spheres/position/time");
  const auto rows = rows_at(times, series);
  group_at(file, "observables");
  for (const RecordedSeries::Column& column : series.columns) {
    const auto count = static_cast<std::ptrdiff_t>(column.numbers_a_row());
    std::vector<double> values;
    for (const std::size_t row : rows) {
      const auto begin = column.values.begin() + static_cast<std::ptrdiff_t>(row) * count;
      values.insert(values.end(), begin, begin + count);
    }
    put_element(file, "observables", "particles/spheres/position", column, values);
  }
}

}  // namespace

void write_series(const Handle& file, const RecordedSeries& series) {
  if (series.time.empty()) return;
  const Handle own = hdf5::opened(file, "zenosphere");
  const Handle group = group_at(own, "series");
  put(group, "step", {}, series.step);
  put(group, "time", {}, series.time);
  for (const RecordedSeries::Column& column : series.columns) {
    put_element(own, "series", "series", column, column.values);
  }
  write_observables(file, series);
}

RecordedSeries read_series(const Handle& file) {
  RecordedSeries series;
  const Handle own = hdf5::opened(file, "zenosphere");
  if (!hdf5::contains(own, "series")) return series;
  const Handle group = hdf5::opened(own, "series");
  series.step = hdf5::values<std::int64_t>(group, "step");
  series.time = hdf5::values<double>(group, "time");
  const auto rows = static_cast<std::int64_t>(series.time.size());
  if (series.step.size() != series.time.size()) throw hdf5::Error("a series without its times");
  const Observables all;
  Observables::fields(all, [&](const std::string& name, const auto&, Shape, Mean) {
    if (!hdf5::contains(group, name)) return;
    const std::string path = name + "/value";
    auto shape = hdf5::shape(group, path);
    if (shape.empty() || shape.front() != rows) throw hdf5::Error(path + " has another length");
    shape.erase(shape.begin());
    series.columns.push_back({name, std::move(shape), hdf5::values<double>(group, path)});
  });
  return series;
}

namespace {

/// Names of the groups or datasets in a group that hold `inner`, or are themselves what is asked
/// for where that is empty.
std::vector<std::string> members(const Handle& group, const std::string& inner) {
  std::vector<std::string> names;
  for (const std::string& path : hdf5::value_names(group)) {
    const std::size_t slash = path.find('/');
    const bool is_inner = slash != std::string::npos && path.substr(slash + 1) == inner;
    const bool is_own = inner.empty() && slash == std::string::npos;
    if (is_inner || is_own) names.push_back(path.substr(0, slash));
  }
  return names;
}

}  // namespace

void write_samples(const Handle& file, const RecordedSamples& samples) {
  if (samples.sums.columns.empty()) return;
  const Handle own = hdf5::opened(file, "zenosphere");
  const Handle group = group_at(own, "samples");
  put(group, "step", {}, samples.sums.step);
  put(group, "time", {}, samples.sums.time);
  for (const RecordedSeries::Column& column : samples.sums.columns) {
    put_element(own, "samples", "samples", column, column.values);
  }
  const Handle edges = group_at(group, "edges");
  for (const RecordedSeries::Column& each : samples.edges) put(edges, each.name, {}, each.values);
}

RecordedSamples read_samples(const Handle& file) {
  RecordedSamples samples;
  const Handle own = hdf5::opened(file, "zenosphere");
  if (!hdf5::contains(own, "samples")) return samples;
  const Handle group = hdf5::opened(own, "samples");
  samples.sums.step = hdf5::values<std::int64_t>(group, "step");
  samples.sums.time = hdf5::values<double>(group, "time");
  const auto rows = static_cast<std::int64_t>(samples.sums.time.size());
  if (samples.sums.step.size() != samples.sums.time.size()) {
    throw hdf5::Error("samples without their times");
  }
  for (const std::string& name : members(group, "value")) {
    const std::string path = name + "/value";
    auto shape = hdf5::shape(group, path);
    if (shape.empty() || shape.front() != rows) throw hdf5::Error(path + " has another length");
    shape.erase(shape.begin());
    samples.sums.columns.push_back({name, std::move(shape), hdf5::values<double>(group, path)});
  }
  const Handle edges = hdf5::opened(group, "edges");
  for (const std::string& name : members(edges, "")) {
    auto values = hdf5::values<double>(edges, name);
    samples.edges.push_back({name, {}, std::move(values)});
  }
  return samples;
}

}  // namespace zenosphere
