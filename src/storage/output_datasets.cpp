#include "storage/output_datasets.hpp"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

#include "storage/anatomy_group.hpp"
#include "storage/build_info.hpp"
#include "storage/checksum.hpp"
#include "storage/hdf5.hpp"
#include "storage/hdf5_series.hpp"
#include "storage/integrity.hpp"
#include "storage/series_group.hpp"

namespace zenosphere {
namespace {

using hdf5::Handle;
using hdf5::Series;
using hdf5::Type;
namespace fs = std::filesystem;

/// Rows by which the file grows: what the shortest run takes, 0.7 MB, stays small.
constexpr std::int64_t log_chunk = 16384;

void write_h5md(const Handle& file) {
  const Handle root = hdf5::created_group(file, "h5md");
  hdf5::write_attribute(root, "version", std::vector<std::int64_t>{1, 1});
  const Handle author = hdf5::created_group(root, "author");
  hdf5::write_attribute(author, "name", "unknown");
  const Handle creator = hdf5::created_group(root, "creator");
  hdf5::write_attribute(creator, "name", "zenosphere");
  hdf5::write_attribute(creator, "version", build_info::program_version);
}

void write_provenance(const Handle& file, const OutputHeader& header) {
  const Handle own = hdf5::created_group(file, "zenosphere");
  hdf5::write_attribute(own, "format_version", output_format_version);
  hdf5::write_attribute(own, "criteria_version", criteria_version);
  hdf5::write_attribute(own, "program_version", build_info::program_version);
  hdf5::write_attribute(own, "git_hash", build_info::git_hash);
  hdf5::write_attribute(own, "compiler", build_info::compiler);
  hdf5::write_attribute(own, "compiler_flags", build_info::compiler_flags);
  hdf5::write_attribute(own, "complete", std::uint8_t{0});
  hdf5::write_text(own, "case", header.case_text);
  hdf5::write_text(own, "resolved", header.resolved_case);
}

/// What does not change with time: diameters, masses and kinds, where they are not all the same.
void write_grains(const Handle& group, const OutputHeader& header) {
  const auto write = [&](const std::string& name, Type type, const auto& values) {
    if (values.empty()) return;
    Series(group, name, type, {}, std::clamp<std::int64_t>(header.spheres, 1, 8192)).append(values);
  };
  const Grains<double>& grains = header.grains;
  write("diameter", Type::float64, grains.diameters);
  write("mass", Type::float64, grains.masses);
  write("species", Type::int32, grains.kinds);
  write("immobile", Type::uint8, grains.immobile);
  if (header.species.empty() || grains.kinds.empty()) return;
  hdf5::write_attribute(hdf5::opened(group, "species"), "names", header.species);
}

/// /particles/spheres without its datasets: what H5MD and its readers know.
void write_particles(const Handle& file, const OutputHeader& header) {
  hdf5::created_group(file, "particles");
  const Handle group = hdf5::created_group(file, "particles/spheres");
  const Handle position = hdf5::created_group(group, "position");
  hdf5::created_group(group, "velocity");
  hdf5::created_group(group, "image");
  if (header.spin_axes > 0) hdf5::created_group(group, "angular_velocity");
  const Handle box = hdf5::created_group(group, "box");
  hdf5::created_group(box, "edges");
  hdf5::write_attribute(box, "dimension", std::int64_t{header.dimension});
  const std::vector<std::string> periodic(static_cast<std::size_t>(header.dimension), "periodic");
  hdf5::write_attribute(box, "boundary", header.boundary.empty() ? periodic : header.boundary);

  const auto create = [&](const std::string& name, Type type,
                          const std::vector<std::int64_t>& shape) {
    std::int64_t bytes = sizeof(double);
    for (const auto extent : shape) bytes *= extent;
    // In chunks of about 64 KiB, which small systems fill with several snapshots.
    Series(group, name, type, shape, std::clamp<std::int64_t>(65536 / bytes, 1, 256));
  };
  create("position/value", Type::float64, {header.spheres, header.dimension});
  create("velocity/value", Type::float64, {header.spheres, header.dimension});
  create("image/value", Type::int32, {header.spheres, header.dimension});
  create("box/edges/value", Type::float64, {header.dimension, header.dimension});
  create("position/step", Type::int64, {});
  create("position/time", Type::float64, {});
  std::vector<std::string> elements{"velocity", "image", "box/edges"};
  if (header.spin_axes > 0) {
    create("angular_velocity/value", Type::float64, {header.spheres, header.spin_axes});
    elements.emplace_back("angular_velocity");
  }
  for (const std::string& element : elements) {
    hdf5::link(group, "position/step", element + "/step");
    hdf5::link(group, "position/time", element + "/time");
  }
  write_grains(group, header);
}

/// Calls `action(name, column, type)` for each column of the log.
template <class Action>
void for_each_column(const CollisionRows& rows, Action action) {
  CollisionRows::fields(rows, [&]<class T>(const char* name, const std::vector<T>& column, auto) {
    action(name, column, hdf5::type_of<T>);
  });
}

void write_log(const Handle& file) {
  const Handle group = hdf5::created_group(file, "collisions");
  hdf5::write_attribute(group, "complete", std::uint8_t{0});
  for_each_column(CollisionRows(), [&](const char* name, const auto&, Type type) {
    Series(group, name, type, {}, log_chunk);
  });
}

class Trajectory {
 public:
  explicit Trajectory(const Handle& file) : group_(hdf5::opened(file, "particles/spheres")) {
    if (!hdf5::contains(group_, "angular_velocity")) return;
    spin_.emplace(group_, "angular_velocity/value", Type::float64);
  }

  void append(const Snapshot& snapshot) {
    const bool fits =
        position_.is_row(snapshot.positions) && velocity_.is_row(snapshot.velocities) &&
        image_.is_row(snapshot.images) && edges_.is_row(snapshot.box_edges) &&
        (spin_ ? spin_->is_row(snapshot.angular_velocities) : snapshot.angular_velocities.empty());
    if (!fits) throw hdf5::Error("a snapshot of another system");
    position_.append(snapshot.positions);
    velocity_.append(snapshot.velocities);
    image_.append(snapshot.images);
    edges_.append(snapshot.box_edges);
    if (spin_) spin_->append(snapshot.angular_velocities);
    step_.append(std::vector{snapshot.step});
    time_.append(std::vector{snapshot.time});
  }
  void truncate(std::int64_t length) {
    for (Series* series : {&position_, &velocity_, &image_, &edges_, &step_, &time_}) {
      series->truncate(length);
    }
    if (spin_) spin_->truncate(length);
  }
  std::int64_t length() const { return step_.length(); }
  int dimension() const { return static_cast<int>(position_.row_shape().at(1)); }

 private:
  Handle group_;
  Series position_{group_, "position/value", Type::float64};
  Series velocity_{group_, "velocity/value", Type::float64};
  Series image_{group_, "image/value", Type::int32};
  std::optional<Series> spin_;  ///< where spheres turn
  Series edges_{group_, "box/edges/value", Type::float64};
  Series step_{group_, "position/step", Type::int64};
  Series time_{group_, "position/time", Type::float64};
};

class CollisionLog {
 public:
  explicit CollisionLog(const Handle& file) : group_(hdf5::opened(file, "collisions")) {
    for_each_column(CollisionRows(), [&](const char* name, const auto&, Type type) {
      columns_.emplace_back(group_, name, type);
    });
  }

  void append(const CollisionRows& rows) {
    auto series = columns_.begin();
    for_each_column(rows, [&](const char*, const auto& column, Type) { series++->append(column); });
  }
  void truncate(std::int64_t length) {
    for (Series& series : columns_) series.truncate(length);
  }
  /// Says whether the log holds all collisions of a run that has ended.
  void mark(bool complete) {
    hdf5::write_attribute(group_, "complete", static_cast<std::uint8_t>(complete));
  }
  std::int64_t length() const { return columns_.front().length(); }

 private:
  Handle group_;
  std::vector<Series> columns_;
};

Handle created(const fs::path& path, const OutputHeader& header) {
  Handle file = hdf5::created_file(path);
  write_provenance(file, header);
  write_particles(file, header);
  write_log(file);
  write_h5md(file);
  hdf5::flush(file);  // so that a full disk is noticed before the run begins
  return file;
}

/// The dataset of a state. It grows and shrinks with it, so that the next one takes its place.
Series state_series(const Handle& checkpoint, std::size_t size) {
  if (hdf5::contains(checkpoint, "state")) return {checkpoint, "state", Type::uint8};
  const std::int64_t chunk =
      std::clamp<std::int64_t>(static_cast<std::int64_t>(size), 1024, 1 << 20);
  return {checkpoint, "state", Type::uint8, {}, chunk};
}

}  // namespace

struct OutputDatasets::Contents {
  explicit Contents(Handle opened) : file(std::move(opened)) {}

  Handle file;  // first, so that it is closed last
  Handle own{hdf5::opened(file, "zenosphere")};
  Trajectory trajectory{file};
  CollisionLog log{file};
};

OutputDatasets::OutputDatasets(const fs::path& path, const OutputHeader& header)
    : contents_(std::make_unique<Contents>(created(path, header))) {}

OutputDatasets::OutputDatasets(const fs::path& path)
    : contents_(std::make_unique<Contents>(hdf5::reopened_file(path))) {}

OutputDatasets::~OutputDatasets() = default;

void OutputDatasets::append(const Snapshot& snapshot) { contents_->trajectory.append(snapshot); }

void OutputDatasets::append(const CollisionRows& rows) { contents_->log.append(rows); }

std::int64_t OutputDatasets::log_rows() const { return contents_->log.length(); }

std::int64_t OutputDatasets::snapshots() const { return contents_->trajectory.length(); }

void OutputDatasets::rewind_to(std::int64_t log_rows, std::int64_t snapshots) {
  contents_->log.truncate(log_rows);
  contents_->trajectory.truncate(snapshots);
  contents_->log.mark(false);
  hdf5::write_attribute(contents_->own, "complete", std::uint8_t{0});
  for (const char* end : {"summary", "anatomy", "adjudication", "checksums"})
    hdf5::remove(contents_->own, end);
}

void OutputDatasets::set_resolved_case(const std::string& text) {
  hdf5::write_text(contents_->own, "resolved", text);
}

void OutputDatasets::store(const Checkpoint& checkpoint) {
  const bool exists = hdf5::contains(contents_->own, "checkpoint");
  const Handle group = exists ? hdf5::opened(contents_->own, "checkpoint")
                              : hdf5::created_group(contents_->own, "checkpoint");
  hdf5::write_attribute(group, "collisions", checkpoint.collisions);
  hdf5::write_attribute(group, "time", checkpoint.time);
  hdf5::write_attribute(group, "clock_units", checkpoint.clock_units);
  hdf5::write_attribute(group, "clock_remainder", checkpoint.clock_remainder);
  hdf5::write_attribute(group, "log_rows", checkpoint.log_rows);
  hdf5::write_attribute(group, "snapshots", checkpoint.snapshots);
  hdf5::write_attribute(group, "wall_seconds", checkpoint.wall_seconds);
  hdf5::write_attribute(group, "checksum", std::int64_t{checksum(checkpoint.state)});
  hdf5::write_attribute(group, "program_version", build_info::program_version);
  hdf5::write_attribute(group, "git_hash", build_info::git_hash);
  hdf5::write_text(group, "summary", checkpoint.summary);
  write_series(contents_->file, checkpoint.series);
  write_samples(contents_->file, checkpoint.samples);
  state_series(group, checkpoint.state.size()).replace(checkpoint.state);
}

void OutputDatasets::finish(const Summary& summary, const Anatomy& anatomy,
                            const RecordedSeries& series, const RecordedSamples& samples) {
  write_series(contents_->file, series);
  write_samples(contents_->file, samples);
  contents_->log.mark(contents_->log.length() == summary.collisions);
  const int dimension = contents_->trajectory.dimension();
  write_anatomy(contents_->own, anatomy, dimension);
  hdf5::write_text(contents_->own, "summary", to_json(summary, dimension));
  hdf5::remove(hdf5::opened(contents_->own, "checkpoint"), "summary");  // the other one holds more
  hdf5::write_attribute(contents_->own, "complete", std::uint8_t{1});
  write_checksums(contents_->file);
}

void OutputDatasets::close() {
  hdf5::flush(contents_->file);
  contents_.reset();
}

void OutputDatasets::abandon() {
  if (contents_) contents_->file.abandon();
  contents_.reset();
}

}  // namespace zenosphere
