#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "verify/findings.hpp"
#include "verify/replay.hpp"

namespace zenosphere {

/// What re-checking a file came to.
struct Verification {
  verify::Findings findings;       ///< contradictions; none: the file may be believed
  verify::Coverage coverage;       ///< how far the motion could be followed
  std::int64_t collisions = 0;     ///< logged
  std::vector<std::string> notes;  ///< what was checked besides, and what could not be
};

/// Checks an output file against itself: the collision log against the snapshots by a replay with
/// its own arithmetic, the summary against the log by counting and by running the criteria again,
/// energy and momentum between snapshots. Before that its bytes are compared with its checksums.
///
/// Throws InputError where the file cannot be read, or its case, and where it is damaged.
Verification verify_file(const std::filesystem::path& path);

/// For people: the contradictions, one a line, and how far each kind of check got.
std::string to_text(const Verification& verification, const std::string& file);

}  // namespace zenosphere
