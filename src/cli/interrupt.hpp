#pragma once

#include <atomic>

namespace zenosphere {

/// A flag that SIGINT, SIGTERM and SIGHUP set; the second signal ends the program at once.
///
/// Also makes a file that grows past the system's limit an error of the write, not a signal.
const std::atomic<bool>& catch_signals();

}  // namespace zenosphere
