#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "collapse/dissection.hpp"
#include "model/grains.hpp"
#include "result/summary.hpp"
#include "storage/records.hpp"

namespace zenosphere {

/// The format that `OutputDatasets` writes; docs/file-format.md tells it.
inline constexpr std::int64_t output_format_version = 1;

/// What an output file says about its run from the start.
struct OutputHeader {
  std::string case_text;      ///< the case file as it was read
  std::string resolved_case;  ///< TOML, every key with the value used
  int dimension = 0;
  std::int64_t spheres = 0;
  std::vector<std::string> boundary{};  ///< D words, "periodic" or "none"; empty: periodic
  Grains<double> grains{};              ///< what the spheres are
  std::vector<std::string> species{};   ///< names of the kinds, in their order; empty: no names
  int spin_axes = 0;                    ///< components of an angular velocity; 0: nothing turns
};

/// The HDF5 side of an output: H5MD 1.1, open for writing.
///
/// A file is not consistent before `close`. Everything throws hdf5::Error; after that the file is
/// to be abandoned.
class OutputDatasets {
 public:
  /// Creates the file; fails if it exists.
  OutputDatasets(const std::filesystem::path& path, const OutputHeader& header);
  /// Opens a file that was written before.
  explicit OutputDatasets(const std::filesystem::path& path);
  OutputDatasets(const OutputDatasets&) = delete;
  OutputDatasets& operator=(const OutputDatasets&) = delete;
  ~OutputDatasets();

  void append(const Snapshot& snapshot);
  void append(const CollisionRows& rows);

  std::int64_t log_rows() const;
  std::int64_t snapshots() const;

  /// Takes back the end of the run, and with it all that came after a checkpoint.
  ///
  /// \param log_rows, snapshots  that are kept
  void rewind_to(std::int64_t log_rows, std::int64_t snapshots);

  void set_resolved_case(const std::string& text);

  /// Stores a checkpoint in place of the one before.
  void store(const Checkpoint& checkpoint);

  /// Writes the summary, what was found in a collapse, the time series, what
  /// was accumulated, the marks of completeness, and the checksums of everything.
  void finish(const Summary& summary, const Anatomy& anatomy, const RecordedSeries& series,
              const RecordedSamples& samples);

  /// Hands everything to the system and closes the file. The last call.
  void close();
  /// Lets go of the file without writing anything more.
  void abandon();

 private:
  struct Contents;
  std::unique_ptr<Contents> contents_;
};

}  // namespace zenosphere
