#include "cli/commands.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.hpp"
#include "cli/command_table.hpp"
#include "cli/console.hpp"
#include "io/build_info.hpp"
#include "model/errors.hpp"

namespace zenosphere {

void add_overrides(CLI::App& command, std::vector<std::string>& overrides) {
  command.add_option("--set", overrides, "override a key, as in system.restitution=0.2")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

namespace {

/// What somebody sees who types the program's name alone.
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
void add_footers(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    const std::string_view example = example_of(command->get_name());
    if (!example.empty()) {
      command->footer(fmt::format("Example:\n  {}\n\nExit codes:\n{}", example, exit_code_lines()));
    }
  }
}

}  // namespace

int run_command_line(int argc, char** argv) {
  if (argc == 1) {
    print(overview);
    return exit_code::done;
  }
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
  add_new(app, status);
  add_examples(app, status);
  add_python_commands(app);
  add_completion(app, status);
  add_manual(app, status);
  add_footers(app);
  try {
    if (argc == 2 && std::string_view(argv[1]) == "help") throw CLI::CallForHelp();
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // help or version was asked for
    const bool is_command_missing = app.get_subcommands().empty();
    if (is_command_missing && argc > 1 && argv[1][0] != '-') {
      throw InputError(
          fmt::format("zenosphere: unknown command {}; run zenosphere --help", argv[1]));
    }
    app.exit(error);
    return exit_code::wrong_input;
  }
  return status;
}

}  // namespace zenosphere
