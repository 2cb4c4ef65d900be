#include "cli/command_table.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <span>
#include <sstream>
#include <utility>

namespace zenosphere {

namespace {

using Example = std::pair<std::string_view, std::string_view>;

constexpr std::array example_lines{
    Example{"run", "zenosphere run sheared.toml -o run.h5 --set system.restitution=0.3"},
    Example{"resume", "zenosphere resume run.h5 --set run.collisions=3000000"},
    Example{"check", "zenosphere check sheared.toml"},
    Example{"info", "zenosphere info run.h5"},
    Example{"adjudicate", "zenosphere adjudicate run.h5 --seconds 60"},
    Example{"verify", "zenosphere verify run.h5"},
    Example{"sweep", "zenosphere sweep study.toml -o study.sqlite"},
    Example{"sweep show", "zenosphere sweep show study.sqlite --run 7 > run-7.toml"},
    Example{"sweep csv", "zenosphere sweep csv study.sqlite -o study.csv"},
    Example{"export", "zenosphere export run.h5 --format extxyz -o run.xyz"},
    Example{"report", "zenosphere report run.h5 -o run.html"},
    Example{"new", "zenosphere new sheared"},
    Example{"examples", "zenosphere examples shear-e06"},
    Example{"figures", "zenosphere figures --run run.h5 -o figures"},
    Example{"report-md", "zenosphere report-md run.h5 -o report.md"},
    Example{"cooling", "zenosphere cooling run.h5 -o cooling.png"},
    Example{"movie", "zenosphere movie run.h5 -o run.mp4"},
    Example{"ensemble", "zenosphere ensemble study.sqlite -o figures"},
    Example{"analyse", "zenosphere analyse run.h5 -o run.csv --figures figures"},
    Example{"completion", "zenosphere completion bash > zenosphere.bash"},
    Example{"manual", "zenosphere manual run | man -l -"},
};

/// What the commands of the Python package take: their own --help tells it, a test compares both.
constexpr std::array words_for_python{
    Example{"figures",
            "[OUT.h5]... [--run OUT.h5]... [--false-positive OUT.h5] [--true-collapse OUT.h5] "
            "[-o DIR] [--format FORMATS] [--size WxH]"},
    Example{"report-md", "OUT.h5... [-o PAGE.md] [--figures DIR]"},
    Example{"cooling", "OUT.h5 [-o FIGURE.png] [--format FORMATS] [--size WxH]"},
    Example{"movie", "OUT.h5 [-o MOVIE.mp4] [--colour COLOUR] [--fps N] [--every N]"},
    Example{"ensemble",
            "STORE.sqlite [-o DIR] [--x KEY] [--y KEY] [--format FORMATS] [--size WxH]"},
};

std::string_view text_for(std::span<const Example> texts, std::string_view command) {
  const auto found = std::find_if(texts.begin(), texts.end(),
                                  [&](const Example& text) { return text.first == command; });
  return found == texts.end() ? std::string_view() : found->second;
}

struct ExitCode {
  std::string_view meaning;
  std::string_view commands;         ///< that can have it, with a blank around each; empty: all
  std::string_view further = {};     ///< what else it means
  std::string_view further_of = {};  ///< to which commands
};
constexpr std::array exit_codes{
    ExitCode{"0 done, whatever the verdict", ""},
    ExitCode{"1 internal error", "", ", or runs of the sweep have failed", " sweep "},
    ExitCode{"2 wrong input", "", ", or the file contradicts itself", " verify "},
    ExitCode{"3 collapsed, only with --fail-on-collapse", " run resume "},
    ExitCode{"4 output could not be written",
             " run resume adjudicate sweep sweep/csv export report new examples figures report-md "
             "cooling movie ensemble "},
    ExitCode{"130 interrupted, with everything saved", " run resume adjudicate sweep "},
};

/// The words that an option takes, from the name of its validator (cli/values.hpp).
void add_choices(CLI::Option& option, CommandOption& entry) {
  try {
    const std::string name = option.get_validator(0)->get_name();
    std::istringstream words(name);
    for (std::string word; std::getline(words, word, ',');) entry.choices.push_back(word);
    entry.has_more_choices = name.ends_with(',');
  } catch (const CLI::OptionNotFound&) {  // no validator
  }
}

CommandOption entry_of(CLI::Option& option) {
  CommandOption entry{.meaning = option.get_description()};
  for (const std::string& name : option.get_snames()) entry.names.push_back('-' + name);
  for (const std::string& name : option.get_lnames()) entry.names.push_back("--" + name);
  if (option.get_type_size() != 0) entry.value = option.get_type_name();
  add_choices(option, entry);
  return entry;
}

void add_commands(CLI::App& parent, const std::string& prefix, std::vector<CommandEntry>& table) {
  for (CLI::App* command : parent.get_subcommands({})) {
    if (command->get_group().empty()) continue;
    CommandEntry entry{.name = prefix + command->get_name(), .meaning = command->get_description()};
    entry.words = text_for(words_for_python, entry.name);
    entry.example = example_of(entry.name);
    for (CLI::Option* option : command->get_options()) {
      const bool is_argument = option->get_positional();
      (is_argument ? entry.arguments : entry.options).push_back(entry_of(*option));
    }
    table.push_back(entry);
    add_commands(*command, entry.name + ' ', table);
  }
}

}  // namespace

std::vector<CommandEntry> command_table(CLI::App& app) {
  std::vector<CommandEntry> table;
  add_commands(app, "", table);
  return table;
}

std::string joined(std::span<const std::string> words, std::string_view separator) {
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += separator;
    text += word;
  }
  return text;
}

std::string_view example_of(std::string_view command) { return text_for(example_lines, command); }

std::string exit_code_lines(std::string_view command) {
  std::string name = ' ' + std::string(command);
  std::replace(name.begin() + 1, name.end(), ' ', '/');
  name += ' ';
  const auto is_among = [&](std::string_view commands) {
    return command.empty() || commands.find(name) != std::string_view::npos;
  };
  std::string text;
  for (const ExitCode& code : exit_codes) {
    if (!code.commands.empty() && !is_among(code.commands)) continue;
    text += code.meaning;
    if (is_among(code.further_of)) text += code.further;
    text += '\n';
  }
  return text;
}

}  // namespace zenosphere
