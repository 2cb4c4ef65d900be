#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

#include "campaign/workers.hpp"

namespace zenosphere {

/// Whether this program was built with MPI.
bool has_mpi();

/// This process as one of several that MPI has started together.
///
/// Rank 0 sees to the sweep and the store; the others do runs (serve_runs). When rank 0 lets go of
/// its session, however that comes about, the others end.
class MpiSession {
 public:
  /// Throws InputError where the program was built without MPI.
  MpiSession();
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;
  ~MpiSession();

  int rank() const { return rank_; }
  int size() const { return size_; }

 private:
  int rank_ = 0;
  int size_ = 1;
};

/// What every rank but 0 does: the runs that rank 0 hands out, until it says that there are no
/// more.
///
/// \param interrupt  set from outside: the run in work is dropped, and all that come
void serve_runs(const MpiSession& session, const std::atomic<bool>& interrupt);

/// The other ranks as seen from rank 0.
class MpiWorkers : public Workers {
 public:
  MpiWorkers(const MpiSession& session, RunSetting setting);

  /// Waits until all have given up what they are at.
  ~MpiWorkers() override;

  std::size_t count() const override { return tasks_of_.size(); }
  std::size_t room() const override;
  void submit(RunTask task) override;
  std::size_t unfinished() const override { return unfinished_; }
  std::vector<RunResult> collect() override;
  void cancel() override;

 private:
  class Outbox;

  void receive_all();

  RunSetting setting_;
  std::vector<std::size_t> tasks_of_;  ///< by rank - 1: handed out, no result yet
  std::size_t unfinished_ = 0;
  std::vector<RunResult> results_;
  std::unique_ptr<Outbox> outbox_;
  bool is_cancelled_ = false;
};

}  // namespace zenosphere
