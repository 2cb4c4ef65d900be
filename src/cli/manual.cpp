#include "cli/manual.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "storage/build_info.hpp"

namespace zenosphere {

namespace {

/// Text for roff: hyphens that stay hyphens, and no line that begins with a control character.
std::string roff(const std::string& text) {
  std::string safe;
  for (const char one : text) {
    if (one == '\\') {
      safe += "\\e";
    } else if (one == '-') {
      safe += "\\-";
    } else if ((one == '.' || one == '\'') && (safe.empty() || safe.back() == '\n')) {
      safe += std::string("\\&") + one;
    } else {
      safe += one;
    }
  }
  return safe;
}

std::string name_of_page(const CommandEntry& command) {
  std::string name = "zenosphere-" + command.name;
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::string heading(const std::string& name, const std::string& meaning) {
  return fmt::format(
      ".TH {} 1 \"\" \"zenosphere {}\" \"User Commands\"\n.ad l\n.SH NAME\n{} \\- {}\n", roff(name),
      build_info::program_version, roff(name), roff(meaning));
}

std::string bold(const std::string& text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + roff(text) + "\\fR"; }

std::string list_item(const CommandOption& option) {
  std::string head;
  for (const std::string& name : option.names) head += (head.empty() ? "" : ", ") + bold(name);
  if (!option.value.empty()) head += (head.empty() ? "" : " ") + italic(option.value);
  std::string text = fmt::format(".TP\n{}\n{}\n", head, roff(option.meaning));
  if (!option.choices.empty()) {
    text += fmt::format("{}: {}.\n", option.has_more_choices ? "For instance" : "One of",
                        roff(joined(option.choices, ", ")));
  }
  return text;
}

std::string exit_status(const std::string& command = "") {
  return ".SH EXIT STATUS\n.nf\n" + roff(exit_code_lines(command)) + ".fi\n";
}

std::string synopsis(const CommandEntry& command) {
  std::string text = ".SH SYNOPSIS\n" + bold("zenosphere " + command.name);
  if (!command.words.empty()) {
    return text + ' ' + roff(command.words) + "\n.SH DESCRIPTION\n" +
           bold("zenosphere " + command.name + " --help") + " tells what each option does.\n";
  }
  for (const CommandOption& argument : command.arguments) text += ' ' + italic(argument.value);
  return text + (command.options.empty() ? "\n" : " [\\fIOPTION\\fR]...\n");
}

}  // namespace

std::string program_manual(std::span<const CommandEntry> commands) {
  std::string text = heading("zenosphere",
                             "event-driven inelastic hard spheres, and whether they "
                             "collapsed or the arithmetic did");
  text += ".SH SYNOPSIS\n.B zenosphere\n.I COMMAND\n[\\fIOPTION\\fR]...\n.SH COMMANDS\n";
  for (const CommandEntry& command : commands) {
    text += fmt::format(".TP\n{}\n{}\n", bold(command.name), roff(command.meaning));
  }
  return text + exit_status() +
         ".SH ENVIRONMENT\n.TP\n.B ZENOSPHERE_PYTHON\nThe interpreter of the commands that draw, "
         "in "
         "place of python3.\n.SH SEE ALSO\nEach command has a page of its own, such as "
         ".BR zenosphere\\-run (1).\n";
}

std::string command_manual(const CommandEntry& command) {
  std::string text = heading(name_of_page(command), command.meaning) + synopsis(command);
  if (!command.arguments.empty()) text += ".SH ARGUMENTS\n";
  for (const CommandOption& argument : command.arguments) text += list_item(argument);
  if (!command.options.empty()) text += ".SH OPTIONS\n";
  for (const CommandOption& option : command.options) text += list_item(option);
  if (!command.example.empty()) {
    text += ".SH EXAMPLE\n.nf\n" + roff(command.example) + "\n.fi\n";
  }
  return text + exit_status(command.name) + ".SH SEE ALSO\n.BR zenosphere (1)\n";
}

}  // namespace zenosphere
