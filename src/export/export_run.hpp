#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>

#include "export/formats.hpp"
#include "export/selection.hpp"
#include "storage/atomic_file.hpp"

namespace zenosphere {

/// What the user asks for.
struct Export {
  std::filesystem::path run;     ///< output file
  std::filesystem::path target;  ///< what is written; the .pvd file of a collection
  const ExportFormat* format = nullptr;
  Selection selection{};
  Existing existing = Existing::refuse;
  const std::atomic<bool>* interrupt = nullptr;  ///< ends it, with nothing written, once true
};

/// What has been written.
struct Exported {
  bool interrupted = false;
  std::int64_t written = 0;  ///< snapshots, or rows of the table of collisions or of the series
  std::int64_t spheres = 0;
  bool complete = false;                ///< the run has ended
  bool collisions_are_counted = false;  ///< each frame holds the collisions of each sphere
};

/// Writes what a run has recorded, with its journal, in the format of another program. One snapshot
/// and a piece of the log are in memory at a time: 56 bytes a sphere and some MB. What cannot be
/// written as a whole is not left in part.
///
/// Throws InputError where the run cannot be read or holds nothing of what is selected, OutputError
/// where the target cannot be written.
Exported export_run(const Export& request);

/// What has been done, for people, in some lines.
std::string to_text(const Exported& exported, const Export& request);

}  // namespace zenosphere
