#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "collapse/dissection.hpp"
#include "model/grains.hpp"
#include "storage/hdf5.hpp"
#include "storage/output_info.hpp"
#include "storage/records.hpp"

namespace zenosphere {

/// The content of an output file alone, snapshot by snapshot and in pieces of the collision log:
/// one part of what RunReader reads.
class StoredRun {
 public:
  /// Throws InputError as read_output_info does, and where columns have different lengths.
  explicit StoredRun(const std::filesystem::path& path);

  const OutputInfo& info() const { return info_; }

  /// Snapshot `n`, from 0. Throws InputError where it cannot be read.
  Snapshot snapshot(std::int64_t n) const;

  /// What the spheres are; all empty where they are unit spheres of one kind. Throws likewise.
  Grains<double> grains() const;

  /// Rows `first` to `first + count - 1` of the log, from 0, likewise.
  std::vector<CollisionRow> rows(std::int64_t first, std::int64_t count) const;

  /// The time series of the run; likewise.
  RecordedSeries series() const;
  /// What the run has accumulated; likewise.
  RecordedSamples samples() const;

  /// What was found at the first hit and at the arrest, as far as it is in the file; likewise.
  Anatomy anatomy() const;

 private:
  /// Snapshots that were read at once: one by one, small ones would take most of the time to find.
  struct Block {
    std::int64_t first = 0;
    std::vector<std::int64_t> steps{};
    std::vector<double> times{}, positions{}, velocities{}, box_edges{};
    std::vector<std::int32_t> images{};
    std::vector<double> angular_velocities{};
  };

  bool has_images() const;  ///< files of earlier programs have none
  /// Components of all angular velocities of a snapshot; 0 where nothing turns.
  std::int64_t spin_components() const;
  void read_block(std::int64_t first) const;

  std::filesystem::path path_;
  OutputInfo info_;
  hdf5::Handle file_;
  mutable Block block_;
};

}  // namespace zenosphere
