#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "model/grains.hpp"
#include "storage/integrity.hpp"
#include "storage/records.hpp"

namespace zenosphere {

/// What an output file says about itself and its run.
struct OutputInfo {
  std::int64_t format_version = 0;
  std::int64_t criteria_version = 1;  ///< of a file that does not say
  std::string program_version, git_hash, compiler, compiler_flags;
  std::string case_text;      ///< the case file as it was read
  std::string resolved_case;  ///< TOML, every key with the value used

  bool complete = false;                    ///< the run ended and everything is written
  std::optional<std::string> summary;       ///< JSON; absent in an unfinished file
  std::optional<std::string> adjudication;  ///< JSON; where zenosphere adjudicate has left it

  int dimension = 0;
  std::int64_t spheres = 0;
  std::int64_t snapshots = 0;
  std::int64_t logged_collisions = 0;
  bool log_complete = false;  ///< every collision of a finished run is in the log

  std::int64_t last_collision = 0;  ///< the farthest that snapshots, log and checkpoint reach
  double last_time = 0;             ///< its time

  /// The last checkpoint, in the file or in its journal, without its state; absent in files of
  /// programs that made none.
  std::optional<Checkpoint> checkpoint;
  Basis basis;  ///< what a journal must go on from: the checkpoint in the file
  Integrity integrity = Integrity::unread;  ///< set by who compares the checksums
  bool is_extended = false;  ///< complete, and a longer run has a checkpoint in the journal
};

/// A state that an output file holds, in laboratory coordinates and row-major.
struct StoredSnapshot {
  int dimension = 0;
  std::int64_t spheres = 0;
  std::vector<double> positions;   ///< N x D, diameters
  std::vector<double> velocities;  ///< N x D, diameters/time
  std::vector<double> box_edges;   ///< D x D, diameters; the rows are the box vectors
  /// N x 3, in two dimensions N, radians/time; empty where nothing turns.
  std::vector<double> angular_velocities{};
  Grains<double> grains{};  ///< only what the file tells: diameters and masses
};

/// Reads an output file, of a finished, an interrupted or a running run, and looks into the journal
/// beside it. Nothing is written or locked.
///
/// Throws InputError where there is no file, it is not HDF5, not of this program, of a newer
/// format, or damaged.
OutputInfo read_output_info(const std::filesystem::path& path);

/// The same from the output file alone, whatever its journal holds: lengths are those of its
/// datasets.
OutputInfo read_stored_info(const std::filesystem::path& path);

/// Reads the checkpoint in an output file, whatever its journal holds.
///
/// Throws InputError as read_output_info does, and where the file holds no whole checkpoint.
Checkpoint read_checkpoint(const std::filesystem::path& path);

/// Whether there is a file that begins as HDF5 files do.
bool is_hdf5_file(const std::filesystem::path& path);

/// Reads a snapshot of an output file, if it has the shape that the caller needs.
///
/// \param number  from 0; none: the last one
/// Throws InputError as read_output_info does, and where the file does not hold that snapshot or
/// those of another number of spheres or dimensions.
StoredSnapshot read_snapshot(const std::filesystem::path& path, int dimension, std::int64_t spheres,
                             std::optional<std::int64_t> number);

}  // namespace zenosphere
