#pragma once

namespace zenosphere {

/// When the averages of a run start: at a time, or where its steady state is found to begin.
class AverageStart {
 public:
  AverageStart(double time) : time_(time) {}  // NOLINT: it is a time
  static AverageStart found() {
    AverageStart start(0);
    start.is_found_ = true;
    return start;
  }

  /// Whether it is looked for in the series of the run.
  bool is_found() const { return is_found_; }
  /// In the case's time unit; 0 where it is looked for.
  double time() const { return time_; }

  friend bool operator==(const AverageStart&, const AverageStart&) = default;

 private:
  double time_;
  bool is_found_ = false;
};

}  // namespace zenosphere
