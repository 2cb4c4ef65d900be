#include <CLI/CLI.hpp>
#include <string>

#include "cli/command.hpp"
#include "cli/commands.hpp"
#include "cli/python_process.hpp"

namespace zenosphere {

namespace {

void add(CLI::App& app, const std::string& name, const std::string& what) {
  CLI::App& command = *app.add_subcommand(name, what);
  command.prefix_command();  // what follows is for Python
  command.set_help_flag();   // its help, too
  command.callback([&command, name] { become_python(name, command.remaining()); });
}

}  // namespace

void add_python_commands(CLI::App& app) {
  add(app, "figures", "draw a run: gaps, time, collisions (Python)");
  add(app, "report-md", "write a Markdown report of runs (Python)");
  add(app, "cooling", "draw the granular temperature against time (Python)");
  add(app, "movie", "draw the snapshots of a run one after another (Python)");
  add(app, "ensemble", "draw and tabulate a sweep's store (Python)");
  add(app, "analyse", "structure, velocities, profiles, transport from snapshots (Python)");
}

}  // namespace zenosphere
