#pragma once

#include <filesystem>
#include <string>

namespace zenosphere {

/// Stores an adjudication, as JSON, in the output file of its run, in place of an older one. The
/// file is replaced in one step.
///
/// Throws InputError where a run is still writing the file or was cut off, OutputError where it
/// could not be written.
void keep_adjudication(const std::filesystem::path& output, const std::string& json);

}  // namespace zenosphere
