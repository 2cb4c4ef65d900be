#include "cli/usage.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>
#include <vector>

#include "text/spelling.hpp"

namespace zenosphere {

namespace {

/// The command that the user has named, `zenosphere sweep show`.
const CLI::App& named_command(const CLI::App& app) {
  const auto named = app.get_subcommands();
  return named.empty() ? app : named_command(*named.front());
}

std::string full_name(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent ? full_name(*parent) + ' ' + command.get_name() : command.get_name();
}

/// `; did you mean --overwrite? See` or `; see`, for what stands in front of the help.
std::string guess(std::string_view word, const std::vector<std::string>& known) {
  const std::vector<std::string_view> candidates(known.begin(), known.end());
  const auto meant = nearest(word, candidates);
  return meant ? fmt::format("; did you mean {}? See", *meant) : "; see";
}

std::string unknown_option(const CLI::App& command, const std::string& word) {
  std::vector<std::string> known;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  }
  const std::string typed = word.substr(0, word.find('='));
  return fmt::format("unknown option {}{}", typed, guess(typed, known));
}

std::string unknown_word(const CLI::App& command, const std::string& word) {
  std::vector<std::string> commands;
  for (const CLI::App* known : command.get_subcommands({})) commands.push_back(known->get_name());
  if (!command.get_parent()) {
    return fmt::format("unknown command {}{}", word, guess(word, commands));
  }
  return fmt::format("{} is one word too many (a name with blanks stands in quotes); see", word);
}

/// What follows an option, and what a word without one is called.
std::string shown(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return option.get_positional() ? type : option.get_name() + ' ' + type;
}

/// Every word that a command cannot do without and that was not typed.
std::string missing_words(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_required() || option->count() > 0) continue;
    text += (text.empty() ? "" : " and ") + shown(*option);
  }
  return text;
}

/// An option with none or too many values; the library's text begins with its name, of a flag
/// without its dashes.
std::string wrong_count(const CLI::App& command, std::string_view text) {
  std::string name(text.substr(0, text.find_first_of(": ")));
  if (!name.starts_with('-')) name.insert(0, "--");
  const CLI::Option* option = command.get_option_no_throw(name);
  if (!option) return fmt::format("{}; see", text);
  if (option->get_expected_max() == 0) return name + " takes no value; see";
  if (option->count() > 1) return fmt::format("{} is given {} times; see", name, option->count());
  return fmt::format("{} needs {} behind it; see", name, option->get_type_name());
}

std::string problem_of(const CLI::App& app, const CLI::App& command, const CLI::ParseError& error) {
  const std::vector<std::string> rest = app.remaining(true);
  const auto option = std::find_if(rest.begin(), rest.end(), [](const std::string& word) {
    return word.size() > 1 && word.front() == '-';
  });
  if (option != rest.end()) return unknown_option(command, *option);
  if (!rest.empty()) return unknown_word(command, rest.front());
  if (error.get_name() == "ArgumentMismatch") return wrong_count(command, error.what());
  if (const std::string words = missing_words(command); !words.empty()) {
    return words + " missing; see";
  }
  if (!command.get_parent()) return "which command? (none is named); see";
  return fmt::format("{}; see", error.what());
}

}  // namespace

std::string usage_problem(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = named_command(app);
  const std::string name = full_name(command);
  return fmt::format("{}: {} {} --help", name, problem_of(app, command, error), name);
}

}  // namespace zenosphere
