#include "cli/completion.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace zenosphere {

namespace {

/// Within single quotes of any of the shells.
std::string quoted(std::string text) {
  std::replace(text.begin(), text.end(), '\'', '`');
  return '\'' + text + '\'';
}

bool is_nested(const CommandEntry& command) { return command.name.find(' ') != std::string::npos; }

std::string names_of_commands(std::span<const CommandEntry> commands, const std::string& prefix) {
  std::string names;
  for (const CommandEntry& command : commands) {
    const bool is_below = command.name.starts_with(prefix) && command.name != prefix &&
                          command.name.find(' ', prefix.size()) == std::string::npos;
    if (is_below) names += (names.empty() ? "" : " ") + command.name.substr(prefix.size());
  }
  return names;
}

/// Options that take a value, with the words it can be.
std::string bash_values(const CommandEntry& command) {
  std::string cases;
  for (const CommandOption& option : command.options) {
    if (option.choices.empty()) continue;
    cases += fmt::format("        {}) COMPREPLY=($(compgen -W {} -- \"$word\")); return ;;\n",
                         joined(option.names, "|"), quoted(joined(option.choices, " ")));
  }
  return cases;
}

/// The words that its arguments can be, where these are few.
std::vector<std::string> words_of_arguments(const CommandEntry& command) {
  std::vector<std::string> words;
  for (const CommandOption& argument : command.arguments) {
    words.insert(words.end(), argument.choices.begin(), argument.choices.end());
  }
  return words;
}

std::string bash(std::span<const CommandEntry> commands) {
  std::string text =
      "# Completion of zenosphere for bash; written by `zenosphere completion bash`.\n"
      "_zenosphere() {\n"
      "  local word=\"${COMP_WORDS[COMP_CWORD]}\" before=\"${COMP_WORDS[COMP_CWORD-1]}\"\n"
      "  local command=\"${COMP_WORDS[1]}\"\n"
      "  [ \"$command\" = sweep ] && case \"${COMP_WORDS[2]}\" in show|csv) "
      "[ \"$COMP_CWORD\" -gt 2 ] && command=\"sweep ${COMP_WORDS[2]}\" ;; esac\n"
      "  COMPREPLY=()\n";
  text += fmt::format(
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
      "    COMPREPLY=($(compgen -W {} -- \"$word\"))\n    return\n  fi\n  case \"$command\" in\n",
      quoted(names_of_commands(commands, "") + " --help --version"));
  for (const CommandEntry& command : commands) {
    std::string options = names_of_commands(commands, command.name + ' ');
    for (const CommandOption& option : command.options) options += ' ' + joined(option.names, " ");
    for (const std::string& name : words_of_arguments(command)) options += ' ' + name;
    text += fmt::format("    {})\n", quoted(command.name));
    if (const std::string values = bash_values(command); !values.empty()) {
      text += "      case \"$before\" in\n" + values + "      esac\n";
    }
    text += fmt::format("      COMPREPLY=($(compgen -W {} -- \"$word\")) ;;\n", quoted(options));
  }
  return text +
         "  esac\n"
         "  [[ \"$word\" == -* ]] || COMPREPLY+=($(compgen -f -- \"$word\"))\n"
         "}\n"
         "complete -o filenames -F _zenosphere zenosphere\n";
}

/// Colons and brackets mean something to zsh.
std::string zsh_text(std::string text) {
  for (const char one : {'[', ']', ':'}) std::replace(text.begin(), text.end(), one, ' ');
  return text;
}

std::string zsh_option(const CommandOption& option) {
  std::string specs;
  for (const std::string& name : option.names) {
    std::string value;
    if (!option.choices.empty()) {
      value = fmt::format(":{}:({})", zsh_text(option.value), joined(option.choices, " "));
    } else if (!option.value.empty()) {
      value = fmt::format(":{}:_files", zsh_text(option.value));
    }
    specs +=
        " \\\n        " + quoted(fmt::format("*{}[{}]{}", name, zsh_text(option.meaning), value));
  }
  return specs;
}

std::string zsh(std::span<const CommandEntry> commands) {
  std::string text =
      "#compdef zenosphere\n"
      "# Completion of zenosphere for zsh; written by `zenosphere completion zsh`.\n"
      "_zenosphere() {\n"
      "  local -a commands=(\n";
  for (const CommandEntry& command : commands) {
    if (is_nested(command)) continue;
    text += "    " + quoted(command.name + ':' + zsh_text(command.meaning)) + '\n';
  }
  text +=
      "  )\n"
      "  if (( CURRENT == 2 )); then\n    _describe command commands\n    return\n  fi\n"
      "  local command=$words[2]\n"
      "  [[ $command == sweep && $words[3] == (show|csv) ]] && command=\"sweep $words[3]\"\n"
      "  shift words; (( CURRENT-- ))\n"
      "  case $command in\n";
  for (const CommandEntry& command : commands) {
    text += fmt::format("    {}) _arguments", quoted(command.name));
    for (const CommandOption& option : command.options) text += zsh_option(option);
    const auto words = words_of_arguments(command);
    text += words.empty() ? " \\\n        '*:file:_files' ;;\n"
                          : fmt::format(" \\\n        '*:word:({})' ;;\n", joined(words, " "));
  }
  return text + "  esac\n}\n_zenosphere \"$@\"\n";
}

std::string fish_condition(const CommandEntry& command) {
  const auto space = command.name.find(' ');
  if (space == std::string::npos) return "__fish_seen_subcommand_from " + command.name;
  return fmt::format("__fish_seen_subcommand_from {}; and __fish_seen_subcommand_from {}",
                     command.name.substr(0, space), command.name.substr(space + 1));
}

std::string fish_option(const CommandEntry& command, const CommandOption& option) {
  std::string names;
  for (const std::string& name : option.names) {
    names += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  std::string value = option.value.empty() ? "" : " -r";
  if (!option.choices.empty()) value += " -f -a " + quoted(joined(option.choices, " "));
  return fmt::format("complete -c zenosphere -n {}{}{} -d {}\n", quoted(fish_condition(command)),
                     names, value, quoted(option.meaning));
}

std::string fish(std::span<const CommandEntry> commands) {
  std::string text =
      "# Completion of zenosphere for fish; written by `zenosphere completion fish`.\n";
  for (const CommandEntry& command : commands) {
    const auto space = command.name.find(' ');
    const std::string where = space == std::string::npos
                                  ? "__fish_use_subcommand"
                                  : "__fish_seen_subcommand_from " + command.name.substr(0, space);
    text += fmt::format("complete -c zenosphere -n {} -a {} -d {}\n", quoted(where),
                        command.name.substr(space == std::string::npos ? 0 : space + 1),
                        quoted(command.meaning));
    for (const CommandOption& option : command.options) text += fish_option(command, option);
    if (const auto words = words_of_arguments(command); !words.empty()) {
      text += fmt::format("complete -c zenosphere -n {} -f -a {}\n",
                          quoted(fish_condition(command)), quoted(joined(words, " ")));
    }
  }
  return text;
}

}  // namespace

std::string completion(Shell shell, std::span<const CommandEntry> commands) {
  switch (shell) {
    case Shell::bash:
      return bash(commands);
    case Shell::zsh:
      return zsh(commands);
    case Shell::fish:
      break;
  }
  return fish(commands);
}

}  // namespace zenosphere
