#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "collapse/approach.hpp"

namespace zenosphere {

/// Separation hits of a run that belong together: of spheres that touch each other, one soon after
/// the other.
struct HitGroup {
  std::int64_t first_hit = 0;  ///< the collision at which the criterion was met, first and last
  std::int64_t last_hit = 0;
  double first_time = 0;
  double last_time = 0;
  std::int32_t i = 0;  ///< the pair of the first hit; j may be a wall
  std::int32_t j = 0;
  std::int64_t hits = 0;
  std::vector<std::int32_t> spheres{};   ///< of its hits, and who led to them; ascending
  std::int64_t from = 0;                 ///< a collision before which its gaps were not small yet
  std::optional<std::int64_t> arrest{};  ///< the collision at which the run was arrested in it
};

/// Whether a collision is one of a group's spheres.
bool is_of(const HitGroup& group, const DepthRow& row);

/// Mean time between two collisions of a sphere up to the first hit of a group.
double mean_time_between_collisions(const HitGroup& group, std::int32_t spheres);

/// Tells the last group that a sphere belongs to of the collision at which the run was arrested
/// with it.
void mark_arrest(std::int32_t sphere, std::int64_t collision, std::vector<HitGroup>& groups);

/// Gathers the hits of a run into groups.
class HitGroups {
 public:
  /// \param spheres  of the system: numbers from there on are walls, which connect no spheres
  explicit HitGroups(std::int32_t spheres);

  /// To be called for every collision, in order.
  void observe(std::int64_t collision, const DepthRow& row);

  /// A hit, before the collision that closes its gap is observed.
  ///
  /// \param collision  at which the criterion was met, and its time since the start
  /// \param next       the pair that comes next
  void observe_hit(std::int64_t collision, double time, const DepthRow& next);

  /// In order of their first hits.
  std::vector<HitGroup> groups() const;

 private:
  void close_before(const HitGroup& hit);
  void trace_back(HitGroup& hit) const;

  struct Numbered {
    std::int64_t collision;
    DepthRow row;
  };

  std::int32_t spheres_;
  std::size_t lead_;              ///< most collisions that a group is followed from before its hit
  std::deque<Numbered> recent_;   ///< the last of them
  std::vector<HitGroup> open_;    ///< to which hits may be added still
  std::vector<HitGroup> closed_;  ///< the clock has gone on since
};

}  // namespace zenosphere
