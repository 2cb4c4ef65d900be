#pragma once

#include <cstdint>
#include <vector>

#include "model/grains.hpp"
#include "storage/records.hpp"

namespace zenosphere {

/// The snapshots of a run as a page shows them: numbers of each, and the spheres of some.
struct Frames {
  std::vector<double> step, time;            ///< of every snapshot
  std::vector<double> granular_temperature;  ///< of every snapshot, (diameter/time)^2
  std::vector<std::int64_t> shown;           ///< which snapshots have the columns below
  std::vector<double> box_edges;             ///< shown x D x D, diameters
  std::vector<float> positions;              ///< shown x N x D, diameters
  std::vector<float> speeds;                 ///< shown x N, peculiar, diameters/time
  std::vector<std::int32_t> collisions;      ///< shown x N, logged up to it; empty: not known
};

/// Numbers, at most `most` and at least two where there are, of snapshots that are as evenly
/// spread as can be, the first and the last among them.
std::vector<std::int64_t> spread_snapshots(std::int64_t snapshots, std::int64_t most);

/// Collects frames, snapshot by snapshot, while the log goes by.
class FrameCollector {
 public:
  /// \param grains      masses, and which are immobile: those have no temperature
  /// \param shear_rate  of the mean flow along x, which peculiar velocities are without, 1/time
  /// \param shown       snapshots whose spheres are kept, ascending
  FrameCollector(std::int64_t spheres, int dimension, Grains<double> grains, double shear_rate,
                 std::vector<std::int64_t> shown);

  /// Counts a collision for its spheres; rows come in the order of the log.
  void observe(const CollisionRow& row);
  /// Takes the next snapshot; the rows up to its step have been observed.
  void observe(const Snapshot& snapshot);
  /// The frames; the collisions of spheres only where the log holds all of them.
  Frames result(bool is_log_complete) &&;

 private:
  void keep(const Snapshot& snapshot);

  std::size_t spheres_;
  int dimension_;
  Grains<double> grains_;
  double shear_rate_;
  std::vector<std::int32_t> counts_;
  Frames frames_;
};

}  // namespace zenosphere
