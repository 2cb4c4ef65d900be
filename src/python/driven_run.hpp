#pragma once

#include <pybind11/numpy.h>

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "run/stepped_run.hpp"

namespace zenosphere {

/// A run that belongs to Python.
///
/// While it goes on, Python's lock is free, and a few times a second Python's signals are looked
/// at: what their handlers raise (KeyboardInterrupt) comes out of the call, with the run as good as
/// before. A second thread that uses the run meanwhile gets a RuntimeError; `stop` may be called by
/// any, and how far the run is may be asked by any.
class DrivenRun {
 public:
  /// A run at its start; with an output, the file is there when this returns.
  DrivenRun(const Case& values, const std::optional<std::string>& output, Existing existing);

  /// A run at the last checkpoint of an output file.
  ///
  /// \param overrides  as `--set` of `zenosphere resume` has them
  DrivenRun(const std::string& output, const std::vector<std::string>& overrides);

  /// Goes on, and gives the rows of the log (K) that are complete; they are not copied.
  ///
  /// \param collisions  at most so many, >= 0; none: no limit
  /// \param until       time since the start; none: no limit
  pybind11::array advance(std::optional<std::int64_t> collisions, std::optional<double> until);

  /// The same without rows.
  void skip(std::optional<std::int64_t> collisions, std::optional<double> until);

  void save();
  std::string finish();               ///< the summary, JSON
  void stop() { interrupt_ = true; }  ///< ends the run at the next collision

  std::string summary() const;  ///< JSON
  /// Collisions done, time, positions (N, D), velocities (N, D), peculiar velocities (N, D), box
  /// edges (D, D).
  pybind11::tuple state() const;

  /// How far the run is; while another thread drives it, as of about a tenth of a second ago.
  bool is_over() const { return seen_.is_over; }
  std::int64_t collisions() const { return seen_.collisions; }
  double time() const { return seen_.time; }

  const Case& values() const { return values_; }

 private:
  class Use;

  /// What every thread may ask, guarded by Python's lock.
  struct Seen {
    std::int64_t collisions;
    double time;
    bool is_over;
  };

  void go_on(std::optional<std::int64_t> collisions, std::optional<double> until,
             std::vector<CollisionRow>* rows);
  template <class Action>
  void attempt(Action action);
  void require_open() const;
  void look();

  Case values_;
  bool has_output_;
  std::atomic<bool> interrupt_{false};
  mutable bool is_used_ = false;  ///< guarded by Python's lock
  std::vector<CollisionRow> rows_;
  std::optional<std::string> failure_;  ///< of the output; nothing can be written any more
  std::optional<std::string> end_;      ///< the summary, once the run is finished
  std::unique_ptr<SteppedRun> run_;
  Seen seen_{};
};

}  // namespace zenosphere
