#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <vector>

#include "campaign/workers.hpp"

namespace zenosphere {

/// How many threads of this process can run at the same time: the cores that it may use.
std::size_t usable_cores();

/// Threads of this process.
class ThreadWorkers : public Workers {
 public:
  /// Throws InputError where the system does not give so many threads.
  ThreadWorkers(RunSetting setting, std::size_t threads);

  /// Ends the threads; what they are at is dropped.
  ~ThreadWorkers() override;

  std::size_t count() const override { return threads_.size(); }
  std::size_t room() const override;
  void submit(RunTask task) override;
  std::size_t unfinished() const override { return unfinished_; }
  std::vector<RunResult> collect() override;
  void cancel() override;

 private:
  void work();
  void end();
  std::size_t most_unfinished() const { return 4 * threads_.size() + 16; }

  const RunSetting setting_;
  std::size_t unfinished_ = 0;  ///< only the calling thread's
  std::atomic<bool> is_cancelled_{false};
  std::mutex mutex_;  ///< of all below
  std::condition_variable task_is_there_, result_is_there_;
  std::deque<RunTask> tasks_;
  std::vector<RunResult> results_;
  bool is_over_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace zenosphere
