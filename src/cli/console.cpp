#include "cli/console.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>

#include "model/errors.hpp"

namespace zenosphere {

void print(const std::string& text) {
  const bool is_written = std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
  if (!is_written) throw OutputError("standard output: could not be written; is the disk full?");
}

void print_aside(const std::string& text) {
  std::fputs(text.c_str(), stderr);  // not fmt::print, which throws where it is closed
}

bool is_terminal() { return isatty(STDERR_FILENO) == 1; }

std::size_t terminal_columns() {
  winsize size{};
  const bool is_known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
  return is_known ? size.ws_col - std::size_t{1} : 79;  // in the last column the line would break
}

void show_line(const std::string& line) {
  const std::size_t width = terminal_columns();
  print_aside(fmt::format("\r{:<{}.{}}", line, width, width));
  std::fflush(stderr);
}

void clear_line() { print_aside(fmt::format("\r{:<{}}\r", "", terminal_columns())); }

}  // namespace zenosphere
