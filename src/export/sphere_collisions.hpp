#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "storage/run_reader.hpp"

namespace zenosphere {

/// How often each sphere has collided, counted along the collision log from snapshot to snapshot.
class SphereCollisions {
 public:
  /// \param run   outlives this
  /// \param path  of its output file, for messages
  SphereCollisions(const RunReader& run, const std::filesystem::path& path);

  /// Whether the log holds every collision up to `step`.
  bool reaches(std::int64_t step) const { return step <= reach_; }

  /// Collisions of each sphere in the first `step` collisions of the run.
  ///
  /// \param step  not lower than in the call before, and reached
  /// Throws InputError where the log contradicts itself.
  std::span<const std::int64_t> up_to(std::int64_t step);

 private:
  void count(const CollisionRow& row);
  void read_piece();

  const RunReader& run_;
  std::filesystem::path path_;
  std::int64_t reach_ = 0;  ///< collisions from the first on that the log holds
  std::int64_t done_ = 0;   ///< collisions counted
  std::int64_t pieces_ = 0;
  std::size_t next_ = 0;  ///< row of the piece
  std::vector<CollisionRow> piece_;
  std::vector<std::int64_t> counts_;
};

}  // namespace zenosphere
