#pragma once

#include <cstddef>
#include <vector>

#include "campaign/run_task.hpp"

namespace zenosphere {

/// Those who do the runs of a sweep, at the same time: threads of this process, or other processes.
///
/// All calls come from one thread.
class Workers {
 public:
  Workers() = default;
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  virtual ~Workers() = default;

  /// How many runs are done at the same time.
  virtual std::size_t count() const = 0;

  /// How many more tasks may be submitted now, so that none idles and little is held in memory.
  virtual std::size_t room() const = 0;

  virtual void submit(RunTask task) = 0;

  /// Runs submitted of which no result has been collected.
  virtual std::size_t unfinished() const = 0;

  /// The results there are; waits for the first one, but no longer than some tenths of a second.
  virtual std::vector<RunResult> collect() = 0;

  /// Asks all to end soon: runs in work, and tasks that wait, come back as dropped.
  virtual void cancel() = 0;
};

}  // namespace zenosphere
