#include "cli/console.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "model/errors.hpp"

namespace zenosphere {

void print(const std::string& text) {
  const bool is_written = std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
  if (!is_written) throw OutputError("standard output: could not be written; is the disk full?");
}

bool is_terminal() { return isatty(STDERR_FILENO) == 1; }

void show_line(const std::string& line) {
  fmt::print(stderr, "\r{:<78}", line);
  std::fflush(stderr);
}

void clear_line() { fmt::print(stderr, "\r{:<78}\r", ""); }

}  // namespace zenosphere
