#include "cli/commands.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.hpp"
#include "io/build_info.hpp"
#include "model/errors.hpp"

namespace zenosphere {

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
