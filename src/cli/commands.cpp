#include "cli/commands.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "cli/citation.hpp"
#include "cli/command.hpp"
#include "cli/command_table.hpp"
#include "cli/console.hpp"
#include "cli/usage.hpp"
#include "model/errors.hpp"
#include "storage/build_info.hpp"

namespace zenosphere {

namespace {

/// What is shown where the program's name is typed alone.
constexpr const char* overview =
    "zenosphere: event-driven inelastic hard spheres. Did they collapse, or did the arithmetic?\n"
    "\n"
    "  zenosphere new sheared                      a commented case to start from, sheared.toml\n"
    "  zenosphere run sheared.toml -o run.h5       run it\n"
    "  zenosphere report run.h5 -o run.html        look at it in a browser\n"
    "  zenosphere adjudicate run.h5                physics or rounding?\n"
    "\n"
    "zenosphere --help lists all commands, zenosphere COMMAND --help the options of one.\n";

/// Below the help of each command: how it is used, and what it returns.
void add_footers(CLI::App& app, const std::string& prefix = "") {
  for (CLI::App* command : app.get_subcommands({})) {
    const std::string name = prefix + command->get_name();
    const std::string_view example = example_of(name);
    if (!example.empty()) {
      command->footer(
          fmt::format("Example:\n  {}\n\nExit codes:\n{}", example, exit_code_lines(name)));
    }
    add_footers(*command, name + ' ');
  }
}

/// `--cite` and `--cite bibtex` end the program as `--version` does.
void add_cite(CLI::App& app) {
  const auto print_it = [](const std::string& format) {
    if (format.empty()) throw CLI::CallForVersion(citation_text(), 0);
    if (format == "bibtex") throw CLI::CallForVersion(citation_bibtex(), 0);
    throw InputError(fmt::format("--cite {}: is no format (must be bibtex, or nothing)", format));
  };
  app.add_option_function<std::string>("--cite", print_it, "say how to cite this program")
      ->expected(0, 1)
      ->type_name("bibtex")
      ->trigger_on_parse();
}

/// `--overwrite=no` is not what it seems.
void refuse_values_of_flags(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (option->get_expected_max() == 0) option->disable_flag_override();
  }
  for (CLI::App* command : app.get_subcommands({})) refuse_values_of_flags(*command);
}

/// What was typed, the last word first, as the library wants it; `help run` stands for
/// `run --help`.
std::vector<std::string> words_of(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && words.front() == "help") {
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  std::reverse(words.begin(), words.end());
  return words;
}

}  // namespace

void add_overrides(CLI::App& command, std::vector<std::string>& overrides) {
  command.add_option("--set", overrides, "override a key, as in system.restitution=0.2")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

int run_command_line(int argc, char** argv) {
  if (argc == 1) {
    print(overview);
    return exit_code::done;
  }
  CLI::App app("Event-driven inelastic hard spheres: did they collapse, or did the arithmetic?",
               "zenosphere");
  app.set_version_flag("-V,--version", std::string("zenosphere ") + build_info::program_version +
                                           " (" + build_info::git_hash + ")");
  add_cite(app);
  app.require_subcommand(1);
  int status = exit_code::internal_error;  // each command sets it
  add_run(app, status);
  add_resume(app, status);
  add_check(app, status);
  add_info(app, status);
  add_adjudicate(app, status);
  add_verify(app, status);
  add_sweep(app, status);
  add_export(app, status);
  add_report(app, status);
  add_new(app, status);
  add_examples(app, status);
  add_python_commands(app);
  add_completion(app, status);
  add_manual(app, status);
  add_footers(app);
  refuse_values_of_flags(app);
  try {
    app.parse(words_of(argc, argv));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // help or version was asked for
    throw InputError(usage_problem(app, error));
  }
  return status;
}

}  // namespace zenosphere
