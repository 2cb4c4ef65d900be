#include "campaign/campaign.hpp"

#include <algorithm>
#include <deque>
#include <utility>

namespace zenosphere {

namespace {

/// The loop of a sweep: tasks out, results in.
class Campaign {
 public:
  Campaign(SweepStore& store, Workers& workers, const SweepOptions& options)
      : store_(store), workers_(workers), options_(options) {
    progress_.counts = store.counts();
  }

  SweepProgress go() {
    hand_out();
    while (workers_.unfinished() > 0) {
      for (const RunResult& result : workers_.collect()) take(result);
      store_.commit_if_due();
      if (is_interrupted()) {
        workers_.cancel();
      } else {
        hand_out();
      }
      report_if_due();
    }
    store_.commit();
    progress_.counts = store_.counts();
    progress_.running = 0;
    progress_.wall_seconds = stopwatch_.seconds();
    return progress_;
  }

 private:
  bool is_interrupted() const { return options_.interrupt && *options_.interrupt; }

  void hand_out() {
    for (std::size_t room = workers_.room(); room > 0 && !is_interrupted(); --room) {
      if (waiting_.empty()) read_on();
      if (waiting_.empty()) return;
      workers_.submit(std::move(waiting_.front()));
      waiting_.pop_front();
    }
  }

  /// Reads the next tasks of the store, where there are any.
  void read_on() {
    constexpr std::int64_t tasks_at_once = 256;
    if (is_read_) return;
    for (RunTask& task : store_.pending(next_, tasks_at_once)) waiting_.push_back(std::move(task));
    is_read_ = waiting_.empty();
    if (!is_read_) next_ = waiting_.back().run + 1;
  }

  void take(const RunResult& result) {
    store_.record(result);
    if (std::holds_alternative<Dropped>(result.outcome)) return;
    ++progress_.ended_here;
    if (std::holds_alternative<Unchanged>(result.outcome)) {
      --progress_.counts.to_adjudicate;
      return;
    }
    const bool is_failed = std::holds_alternative<Failure>(result.outcome);
    ++(is_failed ? progress_.counts.failed : progress_.counts.done);
    --progress_.counts.pending;
  }

  void report_if_due() {
    constexpr double seconds_between = 0.2;
    const double seconds = stopwatch_.seconds();
    if (!options_.on_progress || seconds < next_report_) return;
    next_report_ = seconds + seconds_between;
    progress_.running = std::min(workers_.unfinished(), workers_.count());
    progress_.wall_seconds = seconds;
    options_.on_progress(progress_);
  }

  SweepStore& store_;
  Workers& workers_;
  const SweepOptions& options_;
  Stopwatch stopwatch_;
  SweepProgress progress_;
  std::deque<RunTask> waiting_;
  std::int64_t next_ = 0;
  bool is_read_ = false;
  double next_report_ = 0;
};

}  // namespace

SweepProgress run_sweep(SweepStore& store, Workers& workers, const SweepOptions& options) {
  return Campaign(store, workers, options).go();
}

}  // namespace zenosphere
