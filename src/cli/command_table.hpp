#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace zenosphere {

/// An option or an argument of a command, as help, manual and completion show it.
struct CommandOption {
  std::vector<std::string> names{};  ///< "-o", "--output"; empty for an argument
  std::string value{};               ///< what follows it: "OUT.h5"; empty for a flag
  std::string meaning{};
  std::vector<std::string> choices{};  ///< the words that it takes, where these are few
  bool has_more_choices = false;       ///< and others of their kind
};

/// A command of the program.
struct CommandEntry {
  std::string name;  ///< "sweep show" for one below another
  std::string meaning{};
  std::vector<CommandOption> arguments{};
  std::vector<CommandOption> options{};
  std::string words{};  ///< what may follow the name, where Python reads it; options are then empty
  std::string example{};
};

/// All commands, from the parser itself, so that nothing is written twice.
std::vector<CommandEntry> command_table(CLI::App& app);

/// Words with something between them.
std::string joined(std::span<const std::string> words, std::string_view separator);

/// One line that shows a command at work; empty for an unknown one.
std::string_view example_of(std::string_view command);

/// The exit codes that a command can have, a line each; of all commands where none is named.
///
/// \param command  "run"; for one below another both names, "sweep show"
std::string exit_code_lines(std::string_view command = {});

}  // namespace zenosphere
