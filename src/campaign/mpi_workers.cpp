#include "campaign/mpi_workers.hpp"

#include "model/errors.hpp"

#ifdef ZENOSPHERE_HAS_MPI

// The C++ bindings of old versions of MPI are not used, and warn.
#define OMPI_SKIP_MPICXX 1
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <list>
#include <string>
#include <thread>
#include <utility>

#include "campaign/message.hpp"
#include "campaign/run_case.hpp"
#include "case/case_file.hpp"

namespace zenosphere {

namespace {

/// What a message is about.
enum Tag : int { task_tag = 1, cancel_tag, end_tag, result_tag };

/// A task in work and one that waits: no rank idles while a result travels.
constexpr std::size_t tasks_at_once = 2;

/// Between looks for a message: MPI itself would wait with a core at full load, which on a machine
/// with as many ranks as cores takes the time from one that computes.
constexpr std::chrono::microseconds look_interval(200);

void send(const std::string& text, int rank, Tag tag) {
  MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, rank, tag, MPI_COMM_WORLD);
}

/// Messages on their way. A long one is only taken when its rank has time: none waits for that.
}  // namespace

class MpiWorkers::Outbox {
 public:
  void send(std::string text, int rank, Tag tag) {
    std::erase_if(letters_, [](Letter& letter) { return has_arrived(letter); });
    Letter& letter = letters_.emplace_back();
    letter.text = std::move(text);
    MPI_Isend(letter.text.data(), static_cast<int>(letter.text.size()), MPI_CHAR, rank, tag,
              MPI_COMM_WORLD, &letter.request);
  }

  void wait_for_all() {
    for (Letter& letter : letters_) MPI_Wait(&letter.request, MPI_STATUS_IGNORE);
  }

 private:
  struct Letter {
    std::string text;
    MPI_Request request = MPI_REQUEST_NULL;
  };

  static bool has_arrived(Letter& letter) {
    int is_done = 0;
    MPI_Test(&letter.request, &is_done, MPI_STATUS_IGNORE);
    return is_done != 0;
  }

  std::list<Letter> letters_;  ///< a text stays where it is while it is sent
};

namespace {

struct Message {
  int rank;
  int tag;
  std::string text;
};

/// A message that is there, from any rank; nothing if there is none.
std::optional<Message> next_message(int tag) {
  int is_there = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, tag, MPI_COMM_WORLD, &is_there, &status);
  if (!is_there) return std::nullopt;
  int length = 0;
  MPI_Get_count(&status, MPI_CHAR, &length);
  Message message{status.MPI_SOURCE, status.MPI_TAG,
                  std::string(static_cast<std::size_t>(length), '\0')};
  MPI_Recv(message.text.data(), length, MPI_CHAR, message.rank, message.tag, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return message;
}

Message wait_for_message() {
  for (;;) {
    if (auto message = next_message(MPI_ANY_TAG)) return *std::move(message);
    std::this_thread::sleep_for(look_interval);
  }
}

/// A rank that does runs.
class Server {
 public:
  explicit Server(const std::atomic<bool>& interrupt) : interrupt_(interrupt) {}

  void serve() {
    for (;;) {
      const Message message = wait_for_message();
      if (message.tag == end_tag) return;
      if (message.tag == cancel_tag) is_cancelled_ = true;
      if (message.tag == task_tag) send(answer(message.text), 0, result_tag);
    }
  }

 private:
  bool is_cancelled() {
    if (next_message(cancel_tag)) is_cancelled_ = true;
    return is_cancelled_ || interrupt_;
  }

  std::string answer(const std::string& text) {
    const TaskMessage task = task_from_message(text);
    if (is_cancelled()) return to_message({task.run, Dropped{}}, 0);
    try {
      const Case values = parse_case(task.case_text, "case.toml", {});
      const RunResult result =
          result_of(task.run, values, task.rules, [this] { return is_cancelled(); });
      return to_message(result, values.system.dimension);
    } catch (const std::exception& error) {
      return to_message(failed_result(task.run, task.rules, error.what()), 0);
    }
  }

  const std::atomic<bool>& interrupt_;
  bool is_cancelled_ = false;
};

}  // namespace

bool has_mpi() { return true; }

MpiSession::MpiSession() {
  MPI_Init(nullptr, nullptr);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

MpiSession::~MpiSession() {
  // A rank that fails must not leave rank 0 waiting for its results.
  if (rank_ != 0 && std::uncaught_exceptions() > 0) MPI_Abort(MPI_COMM_WORLD, 1);
  for (int rank = 1; rank_ == 0 && rank < size_; ++rank) send("", rank, end_tag);
  MPI_Finalize();
}

void serve_runs(const MpiSession&, const std::atomic<bool>& interrupt) {
  Server(interrupt).serve();
}

MpiWorkers::MpiWorkers(const MpiSession& session, RunSetting setting)
    : setting_(std::move(setting)),
      tasks_of_(static_cast<std::size_t>(session.size() - 1), 0),
      outbox_(std::make_unique<Outbox>()) {}

MpiWorkers::~MpiWorkers() {
  cancel();
  while (unfinished_ > results_.size()) {
    receive_all();
    std::this_thread::sleep_for(look_interval);
  }
  outbox_->wait_for_all();
}

std::size_t MpiWorkers::room() const {
  return tasks_at_once * count() - std::min(unfinished_, tasks_at_once * count());
}

void MpiWorkers::submit(RunTask task) {
  ++unfinished_;
  TaskMessage message{task.run, {}, setting_.rules(task)};
  try {
    message.case_text = resolved_toml(case_of_run(setting_.base, setting_.stop, task.overrides));
  } catch (const std::exception& error) {
    results_.push_back(failed_result(task.run, message.rules, error.what()));
    return;
  }
  const auto least = std::min_element(tasks_of_.begin(), tasks_of_.end());
  ++*least;
  outbox_->send(to_message(message), static_cast<int>(least - tasks_of_.begin()) + 1, task_tag);
}

void MpiWorkers::receive_all() {
  while (const auto message = next_message(result_tag)) {
    --tasks_of_[static_cast<std::size_t>(message->rank - 1)];
    results_.push_back(result_from_message(message->text));
  }
}

std::vector<RunResult> MpiWorkers::collect() {
  constexpr std::chrono::milliseconds longest_wait(100);
  const auto until = std::chrono::steady_clock::now() + longest_wait;
  receive_all();
  while (results_.empty() && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(look_interval);
    receive_all();
  }
  unfinished_ -= results_.size();
  return std::exchange(results_, {});
}

void MpiWorkers::cancel() {
  if (is_cancelled_) return;
  is_cancelled_ = true;
  for (int rank = 1; rank <= static_cast<int>(count()); ++rank) send("", rank, cancel_tag);
}

}  // namespace zenosphere

#else

namespace zenosphere {

// Built without MPI: nothing below is ever reached but the refusal.

bool has_mpi() { return false; }

MpiSession::MpiSession() {
  throw InputError(
      "zenosphere: started by mpirun or srun as one of several processes, but built without MPI; "
      "install libopenmpi-dev and build again, or start one process with --threads");
}
MpiSession::~MpiSession() = default;
void serve_runs(const MpiSession&, const std::atomic<bool>&) {}
class MpiWorkers::Outbox {};
MpiWorkers::MpiWorkers(const MpiSession&, RunSetting setting) : setting_(std::move(setting)) {}
MpiWorkers::~MpiWorkers() = default;
std::size_t MpiWorkers::room() const { return 0; }
void MpiWorkers::submit(RunTask) {}
void MpiWorkers::receive_all() {}
std::vector<RunResult> MpiWorkers::collect() { return {}; }
void MpiWorkers::cancel() { is_cancelled_ = true; }

}  // namespace zenosphere

#endif
