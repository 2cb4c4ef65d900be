#pragma once

#include <filesystem>

#include "storage/journal.hpp"
#include "storage/output_info.hpp"
#include "storage/records.hpp"

namespace zenosphere {

/// The name under which the next HDF5 file of an output is made.
std::filesystem::path part_of(const std::filesystem::path& output);

/// The output of a run as the run left it, locked, with what is needed to go on.
struct RecoveredOutput {
  std::filesystem::path path;    ///< as the user calls it
  std::filesystem::path target;  ///< without symbolic links
  Journal journal;               ///< cut off behind the last checkpoint; empty if it was void
  OutputInfo info;
  Basis basis;            ///< the checkpoint in the HDF5 file
  Checkpoint checkpoint;  ///< the last one: that in the journal, or that in the file
};

/// Finds the last checkpoint of an output and drops what came after it.
///
/// The HDF5 file is not changed. Throws InputError where there is no output of this program, or
/// none with a checkpoint, or it is damaged, OutputError where it cannot be written or another run
/// is writing it.
RecoveredOutput recover(const std::filesystem::path& path);

}  // namespace zenosphere
