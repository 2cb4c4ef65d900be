#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "run/trial_run.hpp"

namespace zenosphere {

/// A state of the run from which a group of hits is followed.
struct Before {
  HitGroup group;
  std::int64_t collisions = 0;
  int bits = 0;  ///< of the numbers in `state`
  Bytes state{};
};

/// Does a run again, to have the states from which its groups of hits are followed.
///
/// The first group is followed from a collision a sphere (at least a hundred collisions) before its
/// first hit: close enough for all precisions to meet the same spheres before chaos parts them. So
/// is a later one, unless other hits lie between, whose rounding a trial would not share, or gaps
/// of its spheres are still small from an earlier hit. Then it is the latest state in which no two
/// of its spheres are closer than 1e-8 diameters; the start of the case counts as such. Where there
/// is none, it is the one with the widest gaps: the run's own rounding has the say in them.
template <int Dim, class Real>
class Beginnings {
 public:
  /// \param groups  of hits of that run, in the order of their first hits; must outlive this
  /// \param limits  what else ends the run: then the states that follow are not those asked for
  Beginnings(const Case& values, const std::vector<HitGroup>& groups, TrialEnd limits);

  /// The state before a group; to be asked for in their order.
  Before before(std::size_t group);

 private:
  std::int64_t earliest(std::size_t group) const;
  void choose_by_gaps(const Case& values);
  TrialEnd until(std::int64_t collisions) const;

  const std::vector<HitGroup>& groups_;
  TrialEnd limits_;
  std::int64_t lead_;  ///< collisions
  std::vector<std::int64_t> begins_;
  std::vector<std::size_t> order_;  ///< of the groups, by where they begin
  std::size_t next_ = 0;            ///< in `order_`
  std::map<std::size_t, Before> waiting_;
  TrialRun<Dim, Real> run_;
};

}  // namespace zenosphere
