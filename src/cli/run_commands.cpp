#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/case_input.hpp"
#include "cli/command.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/interrupt.hpp"
#include "cli/outputs.hpp"
#include "cli/progress_line.hpp"
#include "run/resume.hpp"
#include "run/run.hpp"
#include "storage/recovery.hpp"
#include "text/printable.hpp"

namespace zenosphere {

namespace {

/// What the user typed.
struct RunArguments {
  std::string file;
  std::optional<std::string> output;
  std::vector<std::string> overrides;
  bool json = false;
  bool quiet = false;
  bool overwrite = false;
  bool fail_on_collapse = false;
};

RunOptions run_options(const RunArguments& arguments) {
  RunOptions options;
  options.interrupt = &catch_signals();
  options.output = arguments.output;
  if (arguments.overwrite) options.existing = Existing::replace;
  if (!arguments.quiet && is_terminal()) {
    options.on_progress = [](const Progress& progress) {
      show_line(progress_line(progress, terminal_columns()));
    };
  }
  return options;
}

int exit_code_of(const Summary& summary, const RunArguments& arguments) {
  if (summary.self_check) {
    fmt::print(stderr, "{}: {}\n", arguments.file, *summary.self_check);
    return exit_code::internal_error;
  }
  if (summary.outcome == Outcome::interrupted) return exit_code::interrupted;
  if (arguments.fail_on_collapse && summary.verdict == Verdict::arrested)
    return exit_code::collapsed;
  return exit_code::done;
}

/// Prints what came out and returns the exit code.
///
/// \param kept  the output file that can be resumed; empty: nothing is kept
int report(const Summary& summary, const Case& values, const RunArguments& arguments,
           const std::string& kept) {
  if (!arguments.quiet && is_terminal()) clear_line();
  if (arguments.json) {
    print(to_json(summary, values.system.dimension) + '\n');
  } else if (!arguments.quiet) {
    print(to_text(summary, values.system.dimension, kept));
  }
  return exit_code_of(summary, arguments);
}

/// Where nothing is kept, and where nothing is even printed.
void tell_what_is_lost(const RunArguments& arguments) {
  if (arguments.output) return;
  if (!arguments.quiet) {
    print_aside(fmt::format("{}: collisions and snapshots are not kept; -o OUT.h5 keeps them\n",
                            printable(arguments.file)));
  } else if (!arguments.json && !arguments.fail_on_collapse) {
    print_aside(
        fmt::format("{}: nothing is kept or printed (--quiet without -o); -o OUT.h5 keeps "
                    "the run, --json prints its summary\n",
                    printable(arguments.file)));
  }
}

int run(const RunArguments& arguments) {
  if (arguments.output) {
    require_file_name(*arguments.output, "HDF5 is not written from its beginning to its end");
    require_other_than(arguments.file, *arguments.output, "the case file itself");
  }
  const Case values = case_from(arguments.file, arguments.overrides);
  tell_what_is_lost(arguments);
  return report(run_case(values, run_options(arguments)), values, arguments,
                arguments.output.value_or(""));
}

int resume(const RunArguments& arguments) {
  RecoveredOutput output = recover(arguments.file);
  const Case values = case_to_resume(output, arguments.overrides);
  const Summary summary = resume_case(values, std::move(output), run_options(arguments));
  return report(summary, values, arguments, arguments.file);
}

void add_reporting(CLI::App& command, RunArguments& arguments) {
  command.add_flag("--json", arguments.json, "print the summary as one JSON object");
  command.add_flag("--quiet", arguments.quiet, "no progress line, no summary for people");
  command.add_flag("--fail-on-collapse", arguments.fail_on_collapse,
                   "exit with 3 if the verdict is true");
}

}  // namespace

void add_run(CLI::App& app, int& status) {
  const auto arguments = std::make_shared<RunArguments>();
  CLI::App& command = *app.add_subcommand("run", "run a case and print what came out");
  command.add_option("case", arguments->file, "case file; - is the standard input")
      ->required()
      ->type_name("CASE.toml");
  command.add_option("-o,--output", arguments->output, "keep collisions and snapshots here")
      ->type_name("OUT.h5");
  add_overrides(command, arguments->overrides);
  add_reporting(command, *arguments);
  command.add_flag("--overwrite", arguments->overwrite, "replace an existing output file");
  command.callback([arguments, &status] { status = run(*arguments); });
}

void add_resume(CLI::App& app, int& status) {
  const auto arguments = std::make_shared<RunArguments>();
  CLI::App& command = *app.add_subcommand(
      "resume", "go on with a run that was cut off, or make a finished one longer");
  command.add_option("file", arguments->file, "output file of a run")
      ->required()
      ->type_name("OUT.h5");
  add_overrides(command, arguments->overrides);
  add_reporting(command, *arguments);
  command.callback([arguments, &status] { status = resume(*arguments); });
}

}  // namespace zenosphere
