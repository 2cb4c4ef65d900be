#include "python/read_output.hpp"

#include <filesystem>
#include <utility>
#include <vector>

#include "python/arrays.hpp"
#include "python/collision_rows.hpp"
#include "python/files.hpp"
#include "storage/info.hpp"
#include "storage/output_info.hpp"
#include "storage/run_reader.hpp"
#include "storage/sandboxed_read.hpp"

namespace zenosphere {

namespace {

namespace py = pybind11;

/// Does a reading of a run, once it went well in a copy of the process; without Python's lock.
template <class Action>
auto read_safely(const std::string& file, Action action) {
  const py::gil_scoped_release unlocked;
  return files.read([&] {
    sandboxed_read(file, bytes_of_run(file), [&] { action(RunReader(file)); });
    return action(RunReader(file));
  });
}

std::vector<CollisionRow> rows_of(const RunReader& run) {
  std::vector<CollisionRow> rows;
  run.for_each_row([&](const CollisionRow& row) { rows.push_back(row); });
  return rows;
}

/// Rows of columns by their names, with "step" and "time".
py::dict arrays_of(RecordedSeries series) {
  const auto rows = static_cast<py::ssize_t>(series.time.size());
  py::dict arrays;
  arrays["step"] = owning_array(std::move(series.step), {rows});
  arrays["time"] = owning_array(std::move(series.time), {rows});
  for (RecordedSeries::Column& column : series.columns) {
    std::vector<py::ssize_t> shape{rows};
    shape.insert(shape.end(), column.shape.begin(), column.shape.end());
    arrays[py::str(column.name)] = owning_array(std::move(column.values), std::move(shape));
  }
  return arrays;
}

}  // namespace

ReadOutput::ReadOutput(std::string file) : file_(std::move(file)) {
  read_safely(file_, [&](const RunReader& run) {
    const OutputInfo info = read_output_info(file_);
    info_ = to_json(info);
    resolved_case_ = info.resolved_case;
    case_text_ = info.case_text;
    has_every_collision_ = info.log_complete;
    dimension_ = info.dimension;
    snapshots_ = run.snapshots();
    return 0;
  });
}

py::array ReadOutput::collisions() const { return owning_rows(read_safely(file_, rows_of)); }

py::dict ReadOutput::series() const {
  return arrays_of(read_safely(file_, [](const RunReader& run) { return run.series(); }));
}

py::dict ReadOutput::samples() const {
  RecordedSamples samples = read_safely(file_, [](const RunReader& run) { return run.samples(); });
  if (samples.sums.columns.empty()) return {};
  py::dict arrays = arrays_of(std::move(samples.sums)), edges;
  for (RecordedSeries::Column& each : samples.edges) {
    const auto count = static_cast<py::ssize_t>(each.values.size());
    edges[py::str(each.name)] = owning_array(std::move(each.values), {count});
  }
  arrays["edges"] = edges;
  return arrays;
}

py::tuple ReadOutput::snapshot(std::int64_t n) const {
  Snapshot snapshot = read_safely(file_, [n](const RunReader& run) { return run.snapshot(n); });
  return py::make_tuple(snapshot.step, snapshot.time,
                        owning_table(std::move(snapshot.positions), dimension_),
                        owning_table(std::move(snapshot.velocities), dimension_),
                        owning_table(std::move(snapshot.box_edges), dimension_),
                        owning_images(std::move(snapshot.images), dimension_),
                        owning_spins(std::move(snapshot.angular_velocities), dimension_));
}

}  // namespace zenosphere
