#include "cli/command_table.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

namespace zenosphere {

namespace {

using Example = std::pair<std::string_view, std::string_view>;

constexpr std::array examples{
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

/// The words that an option takes, from the name of its validator (cli/values.hpp).
std::vector<std::string> choices_of(CLI::Option& option) {
  std::vector<std::string> choices;
  try {
    std::istringstream words(option.get_validator(0)->get_name());
    for (std::string word; std::getline(words, word, ',');) choices.push_back(word);
  } catch (const CLI::OptionNotFound&) {  // no validator
  }
  return choices;
}

CommandOption entry_of(CLI::Option& option) {
  CommandOption entry{.meaning = option.get_description()};
  for (const std::string& name : option.get_snames()) entry.names.push_back('-' + name);
  for (const std::string& name : option.get_lnames()) entry.names.push_back("--" + name);
  if (option.get_type_size() != 0) entry.value = option.get_type_name();
  entry.choices = choices_of(option);
  return entry;
}

void add_commands(CLI::App& parent, const std::string& prefix, std::vector<CommandEntry>& table) {
  for (CLI::App* command : parent.get_subcommands({})) {
    if (command->get_group().empty()) continue;
    CommandEntry entry{.name = prefix + command->get_name(), .meaning = command->get_description()};
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

std::string_view example_of(std::string_view command) {
  const auto found = std::find_if(examples.begin(), examples.end(),
                                  [&](const Example& example) { return example.first == command; });
  return found == examples.end() ? std::string_view() : found->second;
}

std::string_view exit_code_lines() {
  return "0 done, whatever the verdict\n"
         "1 internal error, or runs of a sweep that failed\n"
         "2 wrong input\n"
         "3 collapsed, only with --fail-on-collapse\n"
         "4 output could not be written\n"
         "130 interrupted, with everything saved\n";
}

}  // namespace zenosphere
