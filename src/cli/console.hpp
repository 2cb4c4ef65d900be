#pragma once

#include <string>

namespace zenosphere {

/// Writes to standard output at once. Throws OutputError where that fails.
void print(const std::string& text);

/// Writes to standard error, where what cannot be written is lost.
void print_aside(const std::string& text);

/// Whether standard error is a terminal, where a progress line can be seen.
bool is_terminal();

/// Columns that a line of the terminal has for a progress line; 79 where it does not tell.
std::size_t terminal_columns();

/// Puts a line in the place of the last one, on standard error, cut where the terminal ends.
void show_line(const std::string& line);

/// Clears the line that was shown last.
void clear_line();

}  // namespace zenosphere
