#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

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

  /// Whether nothing more will come: the summary is that of everything there is.
  bool has_ended() const { return complete && !is_extended; }
};

/// Reads an output file, of a finished, an interrupted or a running run, and looks into the journal
/// beside it. Nothing is written or locked.
///
/// Throws InputError where there is no file, it is not HDF5, not of this program, of a newer
/// format, or damaged.
OutputInfo read_output_info(const std::filesystem::path& path);

/// Whether there is a file that begins as HDF5 files do.
bool is_hdf5_file(const std::filesystem::path& path);

}  // namespace zenosphere
