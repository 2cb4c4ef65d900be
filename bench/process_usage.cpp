#include "process_usage.hpp"

#include <sys/resource.h>

#include <chrono>
#include <fstream>
#include <stdexcept>
#include <string>

namespace zenosphere::bench {

namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

ProcessUsage process_usage() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return {seconds(usage.ru_utime), seconds(usage.ru_stime),
          std::chrono::duration<double>(now).count()};
}

ResidentMemory resident_memory() {
  std::ifstream status("/proc/self/status");
  ResidentMemory memory;
  for (std::string line; std::getline(status, line);) {
    constexpr std::size_t label = 6;  // "VmRSS:" or "VmHWM:", then kibibytes
    if (line.starts_with("VmRSS:")) memory.now = 1024 * std::stoll(line.substr(label));
    if (line.starts_with("VmHWM:")) memory.peak = 1024 * std::stoll(line.substr(label));
  }
  if (memory.now == 0 || memory.peak == 0) {
    throw std::runtime_error("/proc/self/status: tells no memory of this process");
  }
  return memory;
}

}  // namespace zenosphere::bench
