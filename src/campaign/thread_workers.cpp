#include "campaign/thread_workers.hpp"

#include <fmt/format.h>
#include <sched.h>

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include "model/errors.hpp"

namespace zenosphere {

std::size_t usable_cores() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  if (sched_getaffinity(0, sizeof cores, &cores) == 0) {
    return static_cast<std::size_t>(std::max(CPU_COUNT(&cores), 1));
  }
  return std::max(std::thread::hardware_concurrency(), 1U);  // more cores than the set can hold
}

ThreadWorkers::ThreadWorkers(RunSetting setting, std::size_t threads)
    : setting_(std::move(setting)) {
  threads_.reserve(threads);
  try {
    for (std::size_t n = 0; n < threads; ++n) threads_.emplace_back([this] { work(); });
  } catch (const std::system_error& error) {
    end();
    throw InputError(fmt::format("--threads: {} threads could not be started ({}); give fewer",
                                 threads, error.code().message()));
  }
}

ThreadWorkers::~ThreadWorkers() { end(); }

void ThreadWorkers::end() {
  is_cancelled_ = true;
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  task_is_there_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

std::size_t ThreadWorkers::room() const {
  return most_unfinished() - std::min(unfinished_, most_unfinished());
}

void ThreadWorkers::submit(RunTask task) {
  {
    const std::lock_guard lock(mutex_);
    tasks_.push_back(std::move(task));
  }
  ++unfinished_;
  task_is_there_.notify_one();
}

std::vector<RunResult> ThreadWorkers::collect() {
  constexpr std::chrono::milliseconds longest_wait(100);
  std::vector<RunResult> results;
  std::unique_lock lock(mutex_);
  result_is_there_.wait_for(lock, longest_wait, [this] { return !results_.empty(); });
  std::swap(results, results_);
  unfinished_ -= results.size();
  return results;
}

void ThreadWorkers::cancel() {
  is_cancelled_ = true;
  const std::lock_guard lock(mutex_);
  for (const RunTask& task : tasks_) results_.push_back({task.run, Dropped{}});
  tasks_.clear();
}

void ThreadWorkers::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    task_is_there_.wait(lock, [this] { return is_over_ || !tasks_.empty(); });
    if (is_over_) return;
    const RunTask task = std::move(tasks_.front());
    tasks_.pop_front();
    lock.unlock();
    RunResult result = result_of(task, setting_, [this] { return is_cancelled_.load(); });
    lock.lock();
    results_.push_back(std::move(result));
    result_is_there_.notify_one();
  }
}

}  // namespace zenosphere
