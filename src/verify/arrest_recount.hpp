#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "case/case.hpp"
#include "collapse/arrest_criterion.hpp"
#include "result/summary.hpp"
#include "storage/records.hpp"
#include "verify/findings.hpp"

namespace zenosphere::verify {

/// Runs the arrest criterion again on a logged run.
///
/// Whether the clock stood between two collisions is in the log (flag 16), how long it stood over
/// many is not: stored times are coarser than the clock. So the criterion runs twice, once with a
/// clock that moves whenever it moved for one collision, and once with the stored times. The first
/// cannot be met before the run met it, the second not after.
class ArrestRecount {
 public:
  ArrestRecount(const Case& values, std::int64_t criteria_version);

  /// \param row       with its number, pair, time and flags
  /// \param gap_before of this pair at the collision before, as the row before has it
  void observe(const CollisionRow& row, double gap_before);

  void compare(const Summary& summary, Findings& findings) const;

 private:
  using Pairs = std::vector<std::pair<std::int64_t, std::int64_t>>;

  ArrestCriterion<1, double> strict_;   ///< any move of the clock ends a stretch
  ArrestCriterion<1, double> lenient_;  ///< stored times
  std::int64_t moves_ = 0;              ///< of the clock: the time of `strict_`
};

}  // namespace zenosphere::verify
