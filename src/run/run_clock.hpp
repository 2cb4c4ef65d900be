#pragma once

#include "run/stopwatch.hpp"

namespace zenosphere {

/// The wall time of a run, and its progress as it is reported now and then.
class RunClock {
 public:
  /// \param earlier_seconds  that the run took before it was resumed
  explicit RunClock(double earlier_seconds = 0) : earlier_seconds_(earlier_seconds) {}

  /// Since the run began or went on [s].
  double seconds() const { return stopwatch_.seconds(); }

  /// Of the whole run, with what it took before it was interrupted [s].
  double wall_seconds() const { return earlier_seconds_ + seconds(); }

  /// Whether so many rounds of the loop more make it worth while to ask for the time.
  bool is_due(int rounds) {
    rounds_left_ -= rounds;
    if (rounds_left_ > 0) return false;
    rounds_left_ = rounds_between;
    return true;
  }
  int rounds_left() const { return rounds_left_; }

  /// Whether progress is to be reported at this time [s]; then the next report comes later.
  bool is_report_due(double seconds) {
    if (seconds < next_report_) return false;
    next_report_ = seconds + 0.2;
    return true;
  }

 private:
  static constexpr int rounds_between = 4096;  // some ms: asking for the time is not free

  Stopwatch stopwatch_;
  double earlier_seconds_;
  int rounds_left_ = rounds_between;
  double next_report_ = 0;  ///< [s]
};

}  // namespace zenosphere
