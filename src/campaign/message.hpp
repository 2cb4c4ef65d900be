#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "campaign/run_task.hpp"

namespace zenosphere {

/// A run as it travels to another process: all that it needs, in one text.
struct TaskMessage {
  std::int64_t run = 0;
  std::string case_text;  ///< resolved
  RunRules rules{};
};

/// JSON, for a program of the same version.
std::string to_message(const TaskMessage& task);
TaskMessage task_from_message(const std::string& text);

/// What became of a run, on its way back. A summary keeps every bit of its finite numbers; one that
/// cannot be read comes back as a failure.
std::string to_message(const RunResult& result, int dimension);
RunResult result_from_message(const std::string& text);

}  // namespace zenosphere
