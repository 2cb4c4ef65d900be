#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "campaign/boundary_rounds.hpp"
#include "campaign/database.hpp"
#include "campaign/run_task.hpp"
#include "campaign/store_lock.hpp"
#include "campaign/stored_sweep.hpp"
#include "campaign/sweep.hpp"
#include "run/stopwatch.hpp"

namespace zenosphere {

/// How many runs of a store are in which state.
struct RunCounts {
  std::int64_t done = 0;
  std::int64_t failed = 0;
  std::int64_t pending = 0;
  std::int64_t to_adjudicate = 0;         ///< of those done: their hits are to be adjudicated
  std::int64_t failed_adjudications = 0;  ///< of those done

  /// Not ended yet.
  std::int64_t left() const { return pending + to_adjudicate; }
  std::int64_t all() const { return done + failed + pending; }
};

RunCounts run_counts(Database& database, const StoredSweep& sweep);

/// The runs of a store in the order of their numbers, as tasks.
class StoredRuns {
 public:
  /// \param database  outlives this
  StoredRuns(Database& database, const StoredSweep& sweep);

  /// At most `count` runs that are still to be done or adjudicated, from the number `from` on.
  std::vector<RunTask> pending(std::int64_t from, std::int64_t count);

  /// The run of that number. Throws InputError where there is none.
  RunTask run(std::int64_t number);

 private:
  RunTask task_in_row(Statement& query) const;
  [[noreturn]] void reject(std::int64_t number);

  std::string name_;
  std::vector<AxisKey> keys_;
  Statement pending_;
  Statement single_;
  Statement highest_;
};

/// The store of a sweep that this process writes: one SQLite file, one row for each run.
///
/// What is recorded becomes part of the file at the next commit, as a whole: a process that ends in
/// between, however it does, leaves a store without those runs, which the next one does again.
/// docs/sweep-file.md has the tables.
class SweepStore {
 public:
  /// Creates the store, or takes over one that holds the same sweep or a part of it.
  ///
  /// Throws InputError where it holds another sweep, OutputError where it cannot be used.
  SweepStore(const std::filesystem::path& path, const Sweep& sweep);

  /// Leaves one file that can be read anywhere, unless another program is reading it.
  ~SweepStore();

  /// The rounds of a search; the store and the sweep must outlive them.
  BoundaryRounds rounds(const Sweep& sweep) { return {database_, sweep}; }

  /// Makes runs that have failed pending again, and adjudications that have.
  void forget_failures();

  std::vector<RunTask> pending(std::int64_t from, std::int64_t count) {
    return runs_->pending(from, count);
  }

  /// What becomes of a run; one that was dropped stays pending.
  void record(const RunResult& result);

  /// Makes what was recorded durable, now or if the last time is a tenth of a second ago.
  void commit();
  void commit_if_due();

  const StoredSweep& sweep() const { return *sweep_; }
  RunSetting setting() const { return {sweep_->base, sweep_->stop, sweep_->adjudicate}; }
  RunCounts counts() { return run_counts(database_, *sweep_); }
  const std::string& name() const { return database_.name(); }

 private:
  void take_over(const Sweep& sweep);
  void record_adjudication(const RunResult& result);

  StoreLock lock_;
  Database database_;
  std::optional<StoredSweep> sweep_;
  std::optional<StoredRuns> runs_;
  std::optional<Statement> done_;
  std::optional<Statement> failed_;
  std::optional<Statement> adjudicated_;
  std::optional<Transaction> transaction_;
  std::optional<Stopwatch> since_begin_;
  std::vector<Cell> cells_;
};

}  // namespace zenosphere
