#pragma once

#include <span>
#include <string>

#include "cli/command_table.hpp"

namespace zenosphere {

enum class Shell { bash, zsh, fish };

/// The script that completes the program's commands, options and file names in a shell.
///
/// Words of an option with few choices are offered; where a value is a file, files are.
std::string completion(Shell shell, std::span<const CommandEntry> commands);

}  // namespace zenosphere
