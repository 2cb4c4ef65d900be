#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "export/frame.hpp"
#include "storage/new_file.hpp"

namespace zenosphere {

/// What a file of some format is made of.
enum class Exports { frames, collection_of_frames, collisions, series };

/// A format in which a run can be written.
struct ExportFormat {
  std::string_view word;     ///< of --format
  std::string_view read_by;  ///< for the help; empty: as the next one
  Exports content;
  bool shows_spheres = false;  ///< it has a place for how often each sphere has collided
  /// Adds a frame to the file; null where the file is none of frames.
  void (*append)(NewFile& file, const Frame& frame) = nullptr;
  /// What stands before the frames, of D dimensions and spheres that turn or not; null: nothing.
  std::string (*header)(int dimension, bool turns) = nullptr;
};

/// All of them.
std::span<const ExportFormat> export_formats();

/// The one of that word; null: there is none.
const ExportFormat* export_format(std::string_view word);

}  // namespace zenosphere
