#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/command_table.hpp"
#include "cli/commands.hpp"
#include "cli/completion.hpp"
#include "cli/console.hpp"
#include "cli/manual.hpp"
#include "cli/values.hpp"
#include "model/errors.hpp"

namespace zenosphere {

namespace {

const std::map<std::string, Shell> shells{
    {"bash", Shell::bash}, {"zsh", Shell::zsh}, {"fish", Shell::fish}};

std::string manual_of(const std::vector<CommandEntry>& table, const std::string& name) {
  if (name.empty()) return program_manual(table);
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const CommandEntry& entry) { return entry.name == name; });
  if (found == table.end()) {
    throw InputError(
        fmt::format("zenosphere manual: no command is called {}; run zenosphere --help", name));
  }
  return command_manual(*found);
}

std::string names_of(const std::vector<CommandEntry>& table) {
  std::string names;
  for (const CommandEntry& entry : table) names += entry.name + '\n';
  return names;
}

}  // namespace

void add_completion(CLI::App& app, int& status) {
  const auto shell = std::make_shared<std::string>();
  CLI::App& command = *app.add_subcommand("completion", "print the completion script of a shell");
  command.add_option("shell", *shell, "bash, zsh or fish")
      ->required()
      ->check(one_of("SHELL", {"bash", "zsh", "fish"}))
      ->type_name("SHELL");
  command.callback([&app, shell, &status] {
    print(completion(shells.at(*shell), command_table(app)));
    status = exit_code::done;
  });
}

void add_manual(CLI::App& app, int& status) {
  const auto words = std::make_shared<std::vector<std::string>>();
  const auto is_list = std::make_shared<bool>(false);
  CLI::App& command = *app.add_subcommand("manual", "print a manual page for man -l -");
  command.add_option("command", *words, "of this command; without it: of the program")
      ->type_name("COMMAND");
  command.add_flag("--list", *is_list, "print the names of the commands that have one");
  command.callback([&app, words, is_list, &status] {
    const auto table = command_table(app);
    print(*is_list ? names_of(table) : manual_of(table, joined(*words, " ")));
    status = exit_code::done;
  });
}

}  // namespace zenosphere
