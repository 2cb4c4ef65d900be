#pragma once

#include <string>

namespace zenosphere {

/// Writes to standard output at once. Throws OutputError where that fails.
void print(const std::string& text);

/// Whether somebody may look at a progress line on standard error.
bool is_terminal();

/// Puts a line in the place of the last one, on standard error.
void show_line(const std::string& line);

/// Clears the line that was shown last.
void clear_line();

}  // namespace zenosphere
