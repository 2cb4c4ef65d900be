#include "cli/commands.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/usage.hpp"
#include "io/build_info.hpp"
#include "model/errors.hpp"

namespace zenosphere {

namespace {

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
  CLI::App app(
      "Event-driven inelastic hard spheres under shear: did it collapse, or the arithmetic?",
      "zenosphere");
  app.set_version_flag("-V,--version", std::string("zenosphere ") + build_info::program_version +
                                           " (" + build_info::git_hash + ")");
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
