#pragma once

#include <filesystem>
#include <optional>

#include "export/draft.hpp"
#include "export/new_file.hpp"

namespace zenosphere {

/// Whether a name stands for standard output: `-`, and what Linux calls it.
bool is_standard_output(const std::filesystem::path& name);

/// Where an export of one file goes: to a file that appears once it is complete, or to standard
/// output as it comes. Every function throws OutputError.
class TextTarget {
 public:
  /// \param occupied  whether a file that is there may be replaced
  TextTarget(const std::filesystem::path& name, Occupied occupied);

  NewFile& file() { return *file_; }

  /// Writes the rest, and gives a file its name. The last call.
  void finish();

 private:
  std::optional<Draft> draft_;  ///< none: standard output
  std::optional<NewFile> file_;
};

}  // namespace zenosphere
