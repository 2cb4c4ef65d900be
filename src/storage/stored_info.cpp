#include "storage/stored_info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "model/errors.hpp"
#include "model/limits.hpp"
#include "storage/hdf5.hpp"
#include "storage/hdf5_series.hpp"
#include "storage/output_datasets.hpp"
#include "storage/sandboxed_read.hpp"
#include "text/file_kind.hpp"
#include "text/printable.hpp"

namespace zenosphere {
namespace {

namespace fs = std::filesystem;
using hdf5::Handle;

[[noreturn]] void reject(const fs::path& path, const std::string& text) {
  throw InputError(path.string() + ": " + text);
}

/// Opens a file of this program whose format this version knows.
Handle opened_output(const fs::path& path) {
  std::error_code ignored;
  const auto status = fs::status(path, ignored);
  if (!fs::exists(status)) reject(path, "does not exist; name an output file of a run");
  if (fs::is_directory(status)) reject(path, "is a folder; name an output file of a run");
  if (!fs::is_regular_file(status)) reject(path, "is not a regular file; name one of a run");
  Handle file;
  try {
    file = hdf5::opened_file(path);
  } catch (const hdf5::Error&) {
    if (hdf5::is_hdf5(path)) throw;
    const FileKind kind = kind_of_file_at(path);
    const bool is_other = kind == FileKind::other || kind == FileKind::output;
    reject(path, is_other ? "is not an HDF5 file; name an output file of a run" : what_it_is(kind));
  }
  if (!hdf5::contains(file, "zenosphere")) {
    reject(path, "has no group /zenosphere (it is not an output of this program)");
  }
  return file;
}

void require_known_format(const fs::path& path, const OutputInfo& info) {
  if (info.format_version <= output_format_version) return;
  reject(path,
         fmt::format("has format version {} (this program reads up to {}); use zenosphere {}, "
                     "which wrote it, or newer",
                     info.format_version, output_format_version, info.program_version));
}

/// The last entry of a dataset of numbers.
template <class T>
T last_value(const Handle& file, const std::string& path, std::int64_t length) {
  T value{};
  if (hdf5::shape(file, path).size() != 1) throw hdf5::Error(path + " is not a column");
  hdf5::read_rows(hdf5::opened(file, path), hdf5::type_of<T>, length - 1, 1, &value);
  return value;
}

void read_provenance(const Handle& own, OutputInfo& info) {
  info.git_hash = hdf5::text_attribute(own, "git_hash");
  info.compiler = hdf5::text_attribute(own, "compiler");
  info.compiler_flags = hdf5::text_attribute(own, "compiler_flags");
  if (hdf5::has_attribute(own, "criteria_version")) {
    info.criteria_version = hdf5::number_attribute(own, "criteria_version");
  }
  info.complete = hdf5::number_attribute(own, "complete") == 1;
  info.case_text = hdf5::text(own, "case");
  info.resolved_case = hdf5::text(own, "resolved");
  if (hdf5::contains(own, "summary")) info.summary = hdf5::text(own, "summary");
  if (hdf5::contains(own, "adjudication")) info.adjudication = hdf5::text(own, "adjudication");
}

std::int64_t extent(const Handle& file, const std::string& path, std::size_t axis) {
  const auto shape = hdf5::shape(file, path);
  if (axis >= shape.size()) throw hdf5::Error(path + " has too few dimensions");
  return shape[axis];
}

void read_extents(const Handle& file, OutputInfo& info) {
  info.spheres = extent(file, "particles/spheres/position/value", 1);
  info.dimension = static_cast<int>(
      std::clamp<std::int64_t>(extent(file, "particles/spheres/position/value", 2), 0, 4));
  info.snapshots = extent(file, "particles/spheres/position/step", 0);
  info.logged_collisions = extent(file, "collisions/k", 0);
  const Handle log = hdf5::opened(file, "collisions");
  info.log_complete = hdf5::number_attribute(log, "complete") == 1;
}

void read_end(const Handle& file, OutputInfo& info) {
  if (const auto rows = info.snapshots; rows > 0) {
    info.last_collision = last_value<std::int64_t>(file, "particles/spheres/position/step", rows);
    info.last_time = last_value<double>(file, "particles/spheres/position/time", rows);
  }
  if (const auto rows = info.logged_collisions; rows > 0) {
    const auto last = last_value<std::int64_t>(file, "collisions/k", rows);
    if (last <= info.last_collision) return;
    info.last_collision = last;
    info.last_time = last_value<double>(file, "collisions/time", rows);
  }
}

void read_checkpoint(const Handle& own, const fs::path& path, OutputInfo& info) {
  const Handle group = hdf5::opened(own, "checkpoint");
  Checkpoint checkpoint;
  checkpoint.collisions = hdf5::number_attribute(group, "collisions");
  checkpoint.time = hdf5::real_attribute(group, "time");
  checkpoint.clock_units = hdf5::real_attribute(group, "clock_units");
  checkpoint.clock_remainder = hdf5::real_attribute(group, "clock_remainder");
  checkpoint.log_rows = hdf5::number_attribute(group, "log_rows");
  checkpoint.snapshots = hdf5::number_attribute(group, "snapshots");
  checkpoint.wall_seconds = hdf5::real_attribute(group, "wall_seconds");
  if (hdf5::contains(group, "summary")) checkpoint.summary = hdf5::text(group, "summary");
  const std::int64_t state_size = extent(group, "state", 0);
  if (static_cast<std::uintmax_t>(state_size) > fs::file_size(path)) {
    throw hdf5::Error("the checkpoint is larger than the file");
  }
  info.basis = {checkpoint.collisions, checkpoint.log_rows, checkpoint.snapshots,
                static_cast<std::uint64_t>(state_size),
                static_cast<std::uint32_t>(hdf5::number_attribute(group, "checksum"))};
  info.checkpoint = std::move(checkpoint);
}

/// Throws where the numbers that the file is about cannot be those of a run.
void require_plausible(const OutputInfo& info) {
  if (info.dimension < 1 || info.dimension > 3) throw hdf5::Error("dimension not in [1, 3]");
  if (info.spheres < 1 || info.spheres > most_spheres) throw hdf5::Error("too many spheres");
  const bool is_named = is_plain(info.program_version) && is_plain(info.git_hash);
  if (!is_named) throw hdf5::Error("a program version that is no plain text");
  if (info.snapshots < 0 || info.logged_collisions < 0) throw hdf5::Error("negative extent");
}

OutputInfo info_of(const fs::path& path) {
  try {
    const Handle file = opened_output(path);
    OutputInfo info;
    const Handle own = hdf5::opened(file, "zenosphere");
    info.format_version = hdf5::number_attribute(own, "format_version");
    info.program_version = hdf5::text_attribute(own, "program_version");
    require_known_format(path, info);
    read_provenance(own, info);
    read_extents(file, info);
    require_plausible(info);
    read_end(file, info);
    if (hdf5::contains(own, "checkpoint")) read_checkpoint(own, path, info);
    return info;
  } catch (const hdf5::Error& error) {
    reject(path, fmt::format("cannot be read ({}); it may be damaged", error.what()));
  }
}

Checkpoint checkpoint_of(const fs::path& path) {
  OutputInfo info = info_of(path);
  if (!info.checkpoint) {
    reject(path, fmt::format("holds no checkpoint (zenosphere {} wrote none); run the case again",
                             info.program_version));
  }
  try {
    Checkpoint checkpoint = *std::move(info.checkpoint);
    checkpoint.state =
        hdf5::values<std::uint8_t>(opened_output(path), "zenosphere/checkpoint/state");
    if (Basis::of(checkpoint) != info.basis) throw hdf5::Error("the checksum is another one");
    return checkpoint;
  } catch (const hdf5::Error& error) {
    reject(path,
           fmt::format("has a checkpoint that cannot be read ({}); it is damaged, run the case "
                       "again",
                       error.what()));
  }
}

}  // namespace

OutputInfo read_stored_info(const fs::path& path) {
  sandboxed_read(path, 0, [&] { info_of(path); });
  return info_of(path);
}

Checkpoint read_checkpoint(const fs::path& path) {
  std::error_code ignored;
  const auto bytes = fs::file_size(path, ignored);
  sandboxed_read(path, ignored ? 0 : static_cast<std::int64_t>(bytes),
                 [&] { checkpoint_of(path); });
  return checkpoint_of(path);
}

}  // namespace zenosphere
