#pragma once

#include <filesystem>
#include <optional>

#include "storage/atomic_file.hpp"
#include "storage/new_file.hpp"

namespace zenosphere {

/// Whether a name stands for standard output: `-`, and what Linux calls it.
bool is_standard_output(const std::filesystem::path& name);

/// Where a text goes: to a file that appears once it is complete, or to standard
/// output as it comes. Every function throws OutputError.
class TextTarget {
 public:
  /// \param existing  whether a file that is there may be replaced
  TextTarget(const std::filesystem::path& name, Existing existing);

  NewFile& file() { return *file_; }

  /// Writes the rest, and gives a file its name. The last call.
  void finish();

 private:
  std::optional<AtomicFile> target_;  ///< none: standard output
  std::optional<NewFile> file_;
};

}  // namespace zenosphere
