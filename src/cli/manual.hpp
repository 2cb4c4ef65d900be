#pragma once

#include <span>
#include <string>

#include "cli/command_table.hpp"

namespace zenosphere {

/// The manual page of the program as a whole, zenosphere(1), in man(7) macros.
std::string program_manual(std::span<const CommandEntry> commands);

/// The manual page of a command, zenosphere-run(1).
std::string command_manual(const CommandEntry& command);

}  // namespace zenosphere
