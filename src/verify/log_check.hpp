#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "case/case.hpp"
#include "result/summary.hpp"
#include "storage/records.hpp"
#include "verify/findings.hpp"
#include "verify/law.hpp"

namespace zenosphere::verify {

/// Looks at each row of a collision log by itself and beside the one before, and counts again what
/// the summary counts: nothing here depends on the motion.
class LogCheck {
 public:
  /// \param last_time  that of the file: nothing happens later
  LogCheck(const Case& values, std::int64_t spheres, double last_time)
      : LogCheck(values, spheres, last_time, values.collapse.gap_threshold.nearest_double()) {}

  /// \param loosest_threshold  >= that of the case; gaps between the two may be hits or not
  /// \param grains             of the file
  LogCheck(const Case& values, std::int64_t spheres, double last_time, double loosest_threshold,
           const Grains<double>& grains = {})
      : values_(values),
        law_(values, spheres, grains),
        spheres_(spheres),
        last_time_(last_time),
        loosest_threshold_(loosest_threshold) {}

  /// \return  whether the row is one of this system, so that it can be replayed
  bool observe(const CollisionRow& row, Findings& findings);

  /// Compares with the summary of a log that holds every collision.
  void compare(const Summary& summary, Findings& findings) const;

  /// Energy lost in the collisions since the last call, mass diameter^2/time^2: of a sum over all
  /// of a gas that cools the last ones are rounding. Nothing where walls or friction take up energy
  /// of which the log does not tell.
  std::optional<Law::Number> take_dissipated();
  std::int64_t collisions() const { return collisions_; }

 private:
  bool check_values(const CollisionRow& row, Findings& findings) const;
  void check_order(const CollisionRow& row, Findings& findings) const;
  void check_flags(const CollisionRow& row, Findings& findings) const;
  void add(const CollisionRow& row);

  const Case& values_;
  Law law_;
  std::int64_t spheres_;
  double last_time_;
  double loosest_threshold_;
  std::optional<CollisionRow> last_;
  Summary::Separation separation_;  ///< counted again
  std::int64_t collisions_ = 0;
  std::int64_t absorbed_ = 0;
  std::int64_t overlapped_ = 0;
  std::int64_t receding_ = 0;
  std::int64_t made_elastic_ = 0;
  Law::Number dissipated_ = 0;
};

}  // namespace zenosphere::verify
