#pragma once

#include <pybind11/numpy.h>

#include <string>

namespace zenosphere {

/// What a run has recorded, for Python: its output file, and the journal beside it.
///
/// The file is open only while something is read, so that others may open it meanwhile, h5py in the
/// same process too. Every function throws InputError where it cannot be read.
class ReadOutput {
 public:
  explicit ReadOutput(std::string file);

  std::string info() const { return info_; }  ///< JSON, as `zenosphere info --json` prints it
  std::string resolved_case() const { return resolved_case_; }  ///< TOML
  std::string case_text() const { return case_text_; }
  bool has_every_collision() const { return has_every_collision_; }

  pybind11::array collisions() const;  ///< all rows of the log, structured (K)
  /// The time series: "step" (K), "time" (K) and each observable (K, ...) under its name.
  pybind11::dict series() const;
  /// What has been accumulated: "step", "time" and sums as those of a series, and "edges", a dict.
  /// Empty where nothing was.
  pybind11::dict samples() const;
  std::int64_t snapshots() const { return snapshots_; }
  /// Collisions done, time, positions (N, D), velocities (N, D), box edges (D, D) of snapshot `n`,
  /// from 0.
  pybind11::tuple snapshot(std::int64_t n) const;

 private:
  std::string file_;
  std::string info_, resolved_case_, case_text_;
  bool has_every_collision_ = false;
  int dimension_ = 0;
  std::int64_t snapshots_ = 0;
};

}  // namespace zenosphere
