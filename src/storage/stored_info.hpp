#pragma once

#include <filesystem>

#include "storage/output_info.hpp"

/// The output file without its journal: for the readers in this room.
namespace zenosphere {

/// Reads what an output file says, whatever its journal holds: lengths are those of its datasets.
/// Throws InputError as read_output_info does.
OutputInfo read_stored_info(const std::filesystem::path& path);

/// Reads the checkpoint in an output file, whatever its journal holds.
///
/// Throws InputError as read_output_info does, and where the file holds no whole checkpoint.
Checkpoint read_checkpoint(const std::filesystem::path& path);

}  // namespace zenosphere
