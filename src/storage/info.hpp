#pragma once

#include <string>

#include "storage/output_info.hpp"

namespace zenosphere {

/// The summary of the file's run as one JSON object on one line, with an object `file` added:
/// complete, format_version, program_version, git_hash, spheres, snapshots, logged_collisions,
/// last_collision, last_time, extended_to. Of an unfinished run the state at its last checkpoint,
/// with the outcome "unfinished".
std::string to_json(const OutputInfo& info);

/// The same for people.
///
/// \param name  of the file, for what can be done with it
std::string to_text(const OutputInfo& info, const std::string& name);

}  // namespace zenosphere
