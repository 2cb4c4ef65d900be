#include "io/output_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "io/build_info.hpp"
#include "io/hdf5.hpp"
#include "io/hdf5_series.hpp"
#include "model/errors.hpp"

namespace zenosphere {
namespace {

using hdf5::Handle;
using hdf5::Series;
using hdf5::Type;
namespace fs = std::filesystem;

/// Rows kept in memory: 512 KiB of a float64 column, so that a write costs little a row.
constexpr std::size_t log_buffer = 65536;
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

Handle write_provenance(const Handle& file, const OutputFile::Header& header) {
  Handle own = hdf5::created_group(file, "zenosphere");
  hdf5::write_attribute(own, "format_version", output_format_version);
  hdf5::write_attribute(own, "program_version", build_info::program_version);
  hdf5::write_attribute(own, "git_hash", build_info::git_hash);
  hdf5::write_attribute(own, "compiler", build_info::compiler);
  hdf5::write_attribute(own, "compiler_flags", build_info::compiler_flags);
  hdf5::write_attribute(own, "complete", std::uint8_t{0});
  hdf5::write_text(own, "case", header.case_text);
  hdf5::write_text(own, "resolved", header.resolved_case);
  return own;
}

/// /particles/spheres: what H5MD and its readers know.
class Trajectory {
 public:
  Trajectory(const Handle& file, const OutputFile::Header& header)
      : group_(create(file, header)),
        position_(series("position/value", Type::float64, {header.spheres, header.dimension})),
        velocity_(series("velocity/value", Type::float64, {header.spheres, header.dimension})),
        edges_(series("box/edges/value", Type::float64, {header.dimension, header.dimension})),
        step_(series("position/step", Type::int64, {})),
        time_(series("position/time", Type::float64, {})) {
    for (const std::string element : {"velocity", "box/edges"}) {
      hdf5::link(group_, "position/step", element + "/step");
      hdf5::link(group_, "position/time", element + "/time");
    }
  }

  void append(const Snapshot& snapshot) {
    position_.append(snapshot.positions);
    velocity_.append(snapshot.velocities);
    edges_.append(snapshot.box_edges);
    step_.append(std::vector{snapshot.step});
    time_.append(std::vector{snapshot.time});
  }

 private:
  static Handle create(const Handle& file, const OutputFile::Header& header) {
    hdf5::created_group(file, "particles");
    Handle group = hdf5::created_group(file, "particles/spheres");
    hdf5::created_group(group, "position");
    hdf5::created_group(group, "velocity");
    const Handle box = hdf5::created_group(group, "box");
    hdf5::created_group(box, "edges");
    hdf5::write_attribute(box, "dimension", std::int64_t{header.dimension});
    const std::vector<std::string> periodic(static_cast<std::size_t>(header.dimension), "periodic");
    hdf5::write_attribute(box, "boundary", header.boundary.empty() ? periodic : header.boundary);
    return group;
  }

  /// In chunks of about 64 KiB, which small systems fill with several snapshots.
  Series series(const std::string& name, Type type, const std::vector<std::int64_t>& shape) const {
    std::int64_t bytes = sizeof(double);
    for (const auto extent : shape) bytes *= extent;
    return {group_, name, type, shape, std::clamp<std::int64_t>(65536 / bytes, 1, 256)};
  }

  Handle group_;
  Series position_, velocity_, edges_, step_, time_;
};

/// /collisions: buffered in memory, a chunk at a time.
class CollisionLog {
 public:
  explicit CollisionLog(const Handle& file) : group_(hdf5::created_group(file, "collisions")) {
    hdf5::write_attribute(group_, "complete", std::uint8_t{0});
  }

  void append(const CollisionRow& row) {
    k_.pending.push_back(row.k);
    time_.pending.push_back(row.time);
    i_.pending.push_back(row.i);
    j_.pending.push_back(row.j);
    gap_.pending.push_back(row.gap);
    normal_speed_.pending.push_back(row.normal_speed);
    flags_.pending.push_back(row.flags);
    if (k_.pending.size() >= log_buffer) write();
  }

  /// Writes the rows that are still in memory.
  void write() {
    for_each_column([](auto& column) {
      column.stored.append(column.pending);
      column.pending.clear();
    });
  }

  /// Marks a log that holds all `collisions` of the run.
  void finish(std::int64_t collisions) {
    const bool complete = k_.stored.length() == collisions;
    hdf5::write_attribute(group_, "complete", std::uint8_t{complete});
  }

 private:
  template <class T>
  struct Column {
    Column(const Handle& group, const std::string& name)
        : stored(group, name, hdf5::type_of<T>, {}, log_chunk) {
      pending.reserve(log_buffer);
    }
    Series stored;
    std::vector<T> pending;
  };

  template <class Action>
  void for_each_column(Action action) {
    action(k_);
    action(time_);
    action(i_);
    action(j_);
    action(gap_);
    action(normal_speed_);
    action(flags_);
  }

  Handle group_;
  Column<std::int64_t> k_{group_, "k"};
  Column<double> time_{group_, "time"};
  Column<std::int32_t> i_{group_, "i"}, j_{group_, "j"};
  Column<double> gap_{group_, "gap"}, normal_speed_{group_, "normal_speed"};
  Column<std::uint8_t> flags_{group_, "flags"};
};

/// Where the file is to be in the end.
/// Throws OutputError where the folder is missing or something is there that may not be replaced.
fs::path permitted_target(const fs::path& path, OutputFile::Existing existing) {
  std::error_code ignored;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const auto refuse = [&path](const std::string& text) {
    throw OutputError(path.string() + ": " + text);
  };
  if (!fs::is_directory(folder, ignored)) {
    refuse(fmt::format("there is no folder {}; create it or choose another", folder.string()));
  }
  const auto status = fs::status(path, ignored);
  if (!fs::exists(status)) return path;
  if (fs::is_directory(status)) refuse("is a folder; choose the name of a file");
  if (existing == OutputFile::Existing::refuse) {
    refuse("exists already (a run's data may be in it); choose another name or pass --overwrite");
  }
  if (!fs::is_regular_file(status)) refuse("is not a regular file; choose another name");
  return fs::is_symlink(path, ignored) ? fs::canonical(path, ignored) : path;
}

/// The name under which a file that may replace another is made.
fs::path temporary_name(const fs::path& target) {
  fs::path name = target;
  name += fmt::format(".{}.part", getpid());
  std::error_code ignored;
  fs::remove(name, ignored);  // of a process with our number that was killed
  return name;
}

}  // namespace

struct OutputFile::Contents {
  Contents(Handle created, const Header& header)
      : file(std::move(created)),
        own(write_provenance(file, header)),
        trajectory(file, header),
        log(file) {
    write_h5md(file);
    hdf5::flush(file);
  }

  Handle file;  // first, so that it is closed last
  Handle own;
  Trajectory trajectory;
  CollisionLog log;
};

void OutputFile::check_target(const fs::path& path, Existing existing) {
  permitted_target(path, existing);
}

OutputFile::OutputFile(const fs::path& path, const Header& header, Existing existing)
    : path_(path), dimension_(header.dimension), spheres_(header.spheres) {
  const fs::path target = permitted_target(path, existing);
  const fs::path name = existing == Existing::refuse ? target : temporary_name(target);
  bool created = false;
  try {
    Handle file = hdf5::created_file(name);
    created = true;
    contents_ = std::make_unique<Contents>(std::move(file), header);
    std::error_code failure;
    fs::rename(name, target, failure);
    if (failure) throw hdf5::Error(failure.message());
  } catch (const std::exception& error) {
    contents_.reset();
    std::error_code ignored;
    if (created) fs::remove(name, ignored);
    throw OutputError(fmt::format("{}: could not be created ({}); choose another place",
                                  path.string(), error.what()));
  }
}

OutputFile::~OutputFile() {
  if (!contents_) return;
  try {
    flush();
  } catch (const std::exception&) {
    // Nobody is left to be told; what was flushed before stays.
  }
}

template <class Action>
void OutputFile::guarded(Action action) {
  assert(contents_);  // neither finished nor failed before
  try {
    action();
  } catch (const hdf5::Error& error) {
    contents_->file.abandon();
    contents_.reset();
    throw OutputError(fmt::format(
        "{}: could not be written ({}); it holds what was flushed before, choose another place",
        path_.string(), error.what()));
  }
}

void OutputFile::write(const Snapshot& snapshot) {
  assert(snapshot.positions.size() == static_cast<std::size_t>(spheres_ * dimension_));
  assert(snapshot.velocities.size() == snapshot.positions.size());
  assert(snapshot.box_edges.size() == static_cast<std::size_t>(dimension_ * dimension_));
  guarded([&] { contents_->trajectory.append(snapshot); });
}

void OutputFile::append(const CollisionRow& row) {
  guarded([&] { contents_->log.append(row); });
}

void OutputFile::flush() {
  guarded([&] {
    contents_->log.write();
    hdf5::flush(contents_->file);
  });
}

void OutputFile::finish(const Summary& summary) {
  flush();
  guarded([&] {
    contents_->log.finish(summary.collisions);
    hdf5::write_text(contents_->own, "summary", to_json(summary, dimension_));
    hdf5::flush(contents_->file);
    hdf5::write_attribute(contents_->own, "complete", std::uint8_t{1});
    hdf5::flush(contents_->file);
    contents_.reset();
  });
}

}  // namespace zenosphere
