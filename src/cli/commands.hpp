#pragma once

namespace zenosphere {

/// What the program returns to the shell; part of its interface.
namespace exit_code {
inline constexpr int done = 0;
inline constexpr int internal_error = 1;
inline constexpr int wrong_input = 2;
inline constexpr int collapsed = 3;  ///< only with --fail-on-collapse
inline constexpr int output_failed = 4;
inline constexpr int interrupted = 130;
}  // namespace exit_code

/// Reads the command line, does what it says and returns the exit code.
///
/// Throws InputError and OutputError with a text for the user.
int run_command_line(int argc, char** argv);

}  // namespace zenosphere
