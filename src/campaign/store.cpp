#include "campaign/store.hpp"

#include <fmt/format.h>

#include <array>

#include "campaign/adjudication_columns.hpp"
#include "campaign/grid_rows.hpp"
#include "campaign/run_columns.hpp"
#include "campaign/start_files.hpp"
#include "campaign/stored_adjudication.hpp"
#include "model/errors.hpp"
#include "storage/build_info.hpp"

namespace zenosphere {

namespace {

/// A commit costs some tenths of a millisecond: as much as a tiny run.
constexpr double seconds_between_commits = 0.1;

std::vector<AxisKey> keys_of(const StoredSweep& sweep) {
  std::vector<AxisKey> keys;
  for (const StoredAxis& axis : sweep.axes) keys.push_back(axis.key);
  return keys;
}

std::string done_sql() {
  std::string sql = "UPDATE run SET status = 'done', error = NULL";
  for (const ResultColumn& column : result_columns()) sql += fmt::format(", {} = ?", column.name);
  return sql + " WHERE run = ?";
}

std::string adjudicated_sql() {
  std::string sql = "UPDATE run SET error = ?";
  for (const AdjudicationColumn& column : adjudication_columns()) {
    sql += fmt::format(", {} = ?", column.name);
  }
  return sql + " WHERE run = ?";
}

/// Throws where the pages of a file do not fit together.
void require_whole(Database& database) {
  const std::string verdict = cell_text(database.value("PRAGMA quick_check(1)"));
  if (verdict == "ok") return;
  throw OutputError(
      fmt::format("{}: is damaged ({}); restore a copy of it, or begin another store "
                  "with -o",
                  database.name(), verdict));
}

}  // namespace

RunCounts run_counts(Database& database, const StoredSweep& sweep) {
  RunCounts counts;
  Statement query = database.statement(
      fmt::format("SELECT status, count(*), count(*) FILTER (WHERE {}), count(*) FILTER (WHERE "
                  "status = 'done' AND error IS NOT NULL) FROM run GROUP BY status",
                  waits_for_adjudication(sweep)));
  while (query.step()) {
    const std::string status = text_in(query.cell(0), database.name());
    counts.to_adjudicate += integer_in(query.cell(2), database.name());
    counts.failed_adjudications += integer_in(query.cell(3), database.name());
    auto& count = status == "done"     ? counts.done
                  : status == "failed" ? counts.failed
                                       : counts.pending;
    count += integer_in(query.cell(1), database.name());
  }
  return counts;
}

StoredRuns::StoredRuns(Database& database, const StoredSweep& sweep)
    : name_(database.name()),
      keys_(keys_of(sweep)),
      pending_(database.statement(fmt::format(
          "SELECT run, seed{}, status, CASE ended_by WHEN {} THEN collisions "
          "END FROM run WHERE run >= ? AND (status = 'pending' OR {}) ORDER BY run "
          "LIMIT ?",
          axis_columns(keys_), sql_word(EndedBy::wall_time), waits_for_adjudication(sweep)))),
      single_(database.statement(
          fmt::format("SELECT run, seed{} FROM run WHERE run = ?", axis_columns(keys_)))),
      highest_(database.statement("SELECT max(run) FROM run")) {}

std::vector<RunTask> StoredRuns::pending(std::int64_t from, std::int64_t count) {
  std::vector<RunTask> tasks;
  pending_.start(std::array<Cell, 2>{from, count});
  const auto status = static_cast<int>(keys_.size()) + 2;
  while (pending_.step()) {
    RunTask& task = tasks.emplace_back(task_in_row(pending_));
    if (text_in(pending_.cell(status), name_) == "pending") continue;
    task.done.emplace();
    const Cell collisions = pending_.cell(status + 1);
    if (const auto* far = std::get_if<std::int64_t>(&collisions)) task.done->collisions = *far;
  }
  pending_.reset();
  return tasks;
}

RunTask StoredRuns::run(std::int64_t number) {
  single_.start(std::array<Cell, 1>{number});
  if (!single_.step()) reject(number);
  RunTask task = task_in_row(single_);
  single_.reset();
  return task;
}

void StoredRuns::reject(std::int64_t number) {
  highest_.start({});
  highest_.step();
  const Cell highest = highest_.cell(0);
  const auto* run = std::get_if<std::int64_t>(&highest);
  throw InputError(fmt::format("--run {}: there is no such run in {} ({})", number, name_,
                               run ? fmt::format("0 to {}", *run) : "it has none yet"));
}

RunTask StoredRuns::task_in_row(Statement& query) const {
  RunTask task{integer_in(query.cell(0), name_), {}};
  task.overrides.push_back(fmt::format("start.seed={}", integer_in(query.cell(1), name_)));
  for (std::size_t n = 0; n < keys_.size(); ++n) {
    task.overrides.push_back(keys_[n].override_of(cell_text(query.cell(static_cast<int>(n) + 2))));
  }
  return task;
}

SweepStore::SweepStore(const std::filesystem::path& path, const Sweep& sweep)
    : lock_(path), database_(path, Database::Access::write) {
  const bool is_new = is_empty(database_);
  if (!is_new) stored_sweep(database_);  // another program's file is left as it is
  database_.execute("PRAGMA journal_mode = WAL");
  database_.execute("PRAGMA synchronous = NORMAL");
  if (is_new) {
    Transaction transaction(database_);
    create_tables(database_, sweep);
    if (sweep.boundary) create_boundary_table(database_, sweep);
    add_rows(database_, sweep, nullptr);
    keep_start_files(database_, sweep);
    transaction.commit();
  } else {
    take_over(sweep);
  }
  sweep_ = stored_sweep(database_);
  runs_.emplace(database_, *sweep_);
  done_ = database_.statement(done_sql());
  adjudicated_ = database_.statement(adjudicated_sql());
  failed_ = database_.statement(
      "UPDATE run SET status = 'failed', error = ?, program_version = ?, git_hash = ? WHERE run = "
      "?");
}

void SweepStore::take_over(const Sweep& sweep) {
  require_whole(database_);
  const StoredSweep before = stored_sweep(database_);
  require_same_search(database_, sweep);
  require_same(before, sweep, name());
  Transaction transaction(database_);
  upgrade(database_, before);
  add_rows(database_, sweep, &before);
  keep_start_files(database_, sweep);
  update_sweep(database_, sweep);
  transaction.commit();
}

void SweepStore::forget_failures() {
  database_.execute(
      "UPDATE run SET status = 'pending', error = NULL, program_version = NULL, git_hash = NULL "
      "WHERE status = 'failed'");
  database_.execute("UPDATE run SET error = NULL WHERE status = 'done' AND error IS NOT NULL");
}

void SweepStore::record(const RunResult& result) {
  if (std::holds_alternative<Dropped>(result.outcome)) return;
  if (!transaction_) {
    transaction_.emplace(database_);
    since_begin_.emplace();
  }
  if (const auto* failure = std::get_if<Failure>(&result.outcome)) {
    failed_->run(std::array<Cell, 4>{failure->error, std::string(build_info::program_version),
                                     std::string(build_info::git_hash), result.run});
    return;
  }
  if (const auto* summary = std::get_if<Summary>(&result.outcome)) {
    cells_.clear();
    for (ResultColumn& column : result_columns(*summary)) {
      cells_.push_back(std::move(column.cell));
    }
    cells_.emplace_back(result.run);
    done_->run(cells_);
  }
  if (result.adjudication) record_adjudication(result);
}

void SweepStore::record_adjudication(const RunResult& result) {
  const AdjudicationResult& adjudication = *result.adjudication;
  cells_.clear();
  cells_.push_back(or_null(adjudication.error));
  cells_.insert(cells_.end(), adjudication.cells.begin(), adjudication.cells.end());
  cells_.resize(1 + adjudication_columns().size());
  cells_.emplace_back(result.run);
  adjudicated_->run(cells_);
}

SweepStore::~SweepStore() {
  transaction_.reset();
  runs_.reset();
  done_.reset();
  failed_.reset();
  adjudicated_.reset();
  try {  // a log that stays is read as well as before, in folders where its index can be made
    database_.execute("PRAGMA busy_timeout = 0");
    database_.execute("PRAGMA journal_mode = DELETE");
  } catch (const OutputError&) {
  }
}

void SweepStore::commit() {
  if (!transaction_) return;
  transaction_->commit();
  transaction_.reset();
}

void SweepStore::commit_if_due() {
  if (transaction_ && since_begin_->seconds() >= seconds_between_commits) commit();
}

}  // namespace zenosphere
