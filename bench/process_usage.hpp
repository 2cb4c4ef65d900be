#pragma once

#include <cstdint>

namespace zenosphere::bench {

/// What this process has used so far.
struct ProcessUsage {
  double user_seconds = 0;    ///< processor time in the program itself
  double system_seconds = 0;  ///< processor time in the kernel on its behalf
  double wall_seconds = 0;    ///< since some fixed moment
};

ProcessUsage process_usage();

/// Memory of this process that is in RAM.
struct ResidentMemory {
  std::int64_t now = 0;   ///< bytes
  std::int64_t peak = 0;  ///< bytes, the most there ever was
};

/// Throws std::runtime_error where /proc/self/status does not tell (anywhere but on Linux).
ResidentMemory resident_memory();

}  // namespace zenosphere::bench
