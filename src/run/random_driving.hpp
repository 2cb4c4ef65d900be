#pragma once

#include <cstdint>
#include <limits>

#include "case/case.hpp"
#include "flow/measurements.hpp"
#include "model/random.hpp"

namespace zenosphere {

/// White noise that feeds energy to all spheres: independent Gaussian kicks at fixed intervals.
///
/// Every velocity component gains the variance `noise_strength` per time. In a periodic box the
/// total momentum of a kick is removed; walls absorb it.
///
/// Source: Williams & MacKintosh, Phys. Rev. E 54 (1996) R9; the discrete form as in Moon, Shattuck
/// & Swift, Phys. Rev. E 64 (2001) 031303.
template <int Dim, class Real>
class RandomDriving {
 public:
  explicit RandomDriving(const Case& values);

  bool is_on() const { return next_kick_ < std::numeric_limits<double>::infinity(); }

  /// Time of the next kick; infinity without random driving.
  double next_kick() const { return next_kick_; }

  /// Kicks all spheres now and sets the next kick an interval later.
  void kick(Simulation<Dim, Real>& simulation, Measurements<Dim, Real>& measurements);

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    if (!self.is_on()) return;
    archive(self.random_, self.kicks_);
    require_counts(self.kicks_);
    if constexpr (Archive::reads) self.schedule();
  }

 private:
  /// Sets the time of the next kick: no sum of intervals, so that it does not drift by rounding.
  void schedule() { next_kick_ = static_cast<double>(kicks_ + 1) * interval_; }

  Random random_;
  double interval_;
  double step_;  ///< standard deviation of each component of a kick, diameters/time
  bool keeps_momentum_;
  std::int64_t kicks_ = 0;
  double next_kick_ = std::numeric_limits<double>::infinity();
};

}  // namespace zenosphere
