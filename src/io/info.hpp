#pragma once

#include <string>

#include "io/output_reader.hpp"

namespace zenosphere {

/// The summary of the file's run as one JSON object on one line, with an object `file` added:
/// complete, format_version, program_version, git_hash, spheres, snapshots, logged_collisions.
/// Of an unfinished file there is only `file`, with the last collision and time that it holds.
std::string to_json(const OutputInfo& info);

/// The same for people.
std::string to_text(const OutputInfo& info);

}  // namespace zenosphere
