#include "cli/commands.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/interrupt.hpp"
#include "cli/progress_line.hpp"
#include "io/build_info.hpp"
#include "io/case_file.hpp"
#include "io/derived.hpp"
#include "io/info.hpp"
#include "io/keep_adjudication.hpp"
#include "io/output_reader.hpp"
#include "io/printable.hpp"
#include "io/recovery.hpp"
#include "model/errors.hpp"
#include "run/adjudicate.hpp"
#include "run/resume.hpp"
#include "run/run.hpp"
#include "verify/verify.hpp"

namespace zenosphere {

namespace {

/// What the user typed.
struct Arguments {
  std::string file;
  std::optional<std::string> output;
  std::vector<std::string> overrides;
  bool json = false;
  bool quiet = false;
  bool overwrite = false;
  bool fail_on_collapse = false;
  Precision up_to = Precision::digits100;
  std::int64_t collisions = 20000;
};

void print(const std::string& text) {
  const bool is_written = std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
  if (!is_written) throw OutputError("standard output: could not be written; is the disk full?");
}

bool is_terminal() { return isatty(STDERR_FILENO) == 1; }

void show(const Progress& progress) {
  fmt::print(stderr, "\r{:<78}", progress_line(progress));
  std::fflush(stderr);
}

RunOptions run_options(const Arguments& arguments) {
  RunOptions options;
  options.interrupt = &catch_signals();
  options.output = arguments.output;
  if (arguments.overwrite) options.existing = OutputFile::Existing::replace;
  if (!arguments.quiet && is_terminal()) options.on_progress = show;
  return options;
}

int exit_code_of(const Summary& summary, const Arguments& arguments) {
  if (summary.self_check) {
    fmt::print(stderr, "{}: {}\n", arguments.file, *summary.self_check);
    return exit_code::internal_error;
  }
  if (summary.outcome == "interrupted") return exit_code::interrupted;
  if (arguments.fail_on_collapse && summary.verdict == "true") return exit_code::collapsed;
  return exit_code::done;
}

/// Throws where the output cannot be meant as it was typed.
void check_output(const Arguments& arguments) {
  if (!arguments.output) return;
  if (arguments.output->empty()) {
    throw InputError("-o: the file name is empty (an unset shell variable?); name a file");
  }
  std::error_code ignored;  // what does not exist is not the case file
  if (std::filesystem::equivalent(*arguments.output, arguments.file, ignored)) {
    throw OutputError(*arguments.output + ": is the case file itself; choose another name");
  }
}

/// Prints what came out and returns the exit code.
int report(const Summary& summary, const Case& values, const Arguments& arguments) {
  if (!arguments.quiet && is_terminal()) fmt::print(stderr, "\r{:<78}\r", "");
  if (arguments.json) {
    print(to_json(summary, values.system.dimension) + '\n');
  } else if (!arguments.quiet) {
    print(to_text(summary, values.system.dimension));
  }
  return exit_code_of(summary, arguments);
}

int run(const Arguments& arguments) {
  check_output(arguments);
  const Case values = read_case(arguments.file, arguments.overrides);
  if (!arguments.quiet && !arguments.output) {
    fmt::print(stderr, "{}: collisions and snapshots are not kept; -o OUT.h5 keeps them\n",
               arguments.file);
  }
  return report(run_case(values, run_options(arguments)), values, arguments);
}

int resume(const Arguments& arguments) {
  RecoveredOutput output = recover(arguments.file);
  const Case values = case_to_resume(output, arguments.overrides);
  const Summary summary = resume_case(values, std::move(output), run_options(arguments));
  return report(summary, values, arguments);
}

/// Every line behind a `#`, so that what `check` prints is a case file again.
std::string as_comments(const std::string& text) {
  std::string comments;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1);
    comments += "# " + text.substr(begin, end + 1 - begin);
    begin = end + 1;
  }
  return comments;
}

int check(const Arguments& arguments) {
  const Case values = read_case(arguments.file, arguments.overrides);
  print(resolved_toml(values) + '\n' + as_comments(derived_text(values)));
  return exit_code::done;
}

int info(const Arguments& arguments) {
  const OutputInfo info = read_output_info(arguments.file);
  print(arguments.json ? to_json(info) + '\n' : to_text(info, arguments.file));
  return exit_code::done;
}

int adjudicate(const Arguments& arguments) {
  const bool is_output = is_hdf5_file(arguments.file);
  const Case values = is_output ? parse_case(read_output_info(arguments.file).resolved_case,
                                             arguments.file, arguments.overrides)
                                : read_case(arguments.file, arguments.overrides);
  AdjudicationLimits limits{.highest = arguments.up_to,
                            .collisions = arguments.collisions,
                            .interrupt = &catch_signals()};
  if (!arguments.quiet && is_terminal()) {
    limits.on_trial = [](const std::string& name) { fmt::print(stderr, "\r{:<78}", name); };
  }
  const Adjudication result = adjudicate(values, limits);
  if (limits.on_trial) fmt::print(stderr, "\r{:<78}\r", "");
  if (is_output) keep_adjudication(arguments.file, to_json(result));
  if (!arguments.quiet) print(to_text(result));
  if (arguments.json) print(to_json(result) + '\n');
  return exit_code::done;
}

int verify_output(const Arguments& arguments) {
  const Verification verification = verify_file(arguments.file);
  print(printable(to_text(verification, arguments.file)));
  return verification.findings.count() == 0 ? exit_code::done : exit_code::wrong_input;
}

void add_overrides(CLI::App& command, Arguments& arguments) {
  command.add_option("--set", arguments.overrides, "override a key, as in system.restitution=0.2")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void add_reporting(CLI::App& command, Arguments& arguments) {
  command.add_flag("--json", arguments.json, "print the summary as one JSON object");
  command.add_flag("--quiet", arguments.quiet, "no progress line, no summary for people");
  command.add_flag("--fail-on-collapse", arguments.fail_on_collapse,
                   "exit with 3 if the verdict is true");
}

void add_run(CLI::App& app, Arguments& arguments) {
  CLI::App& command = *app.add_subcommand("run", "run a case and print what came out");
  command.add_option("case", arguments.file, "case file")->required()->type_name("CASE.toml");
  command.add_option("-o,--output", arguments.output, "keep collisions and snapshots here")
      ->type_name("OUT.h5");
  add_overrides(command, arguments);
  add_reporting(command, arguments);
  command.add_flag("--overwrite", arguments.overwrite, "replace an existing output file");
}

void add_resume(CLI::App& app, Arguments& arguments) {
  CLI::App& command = *app.add_subcommand(
      "resume", "go on with a run that was cut off, or make a finished one longer");
  command.add_option("file", arguments.file, "output file of a run")
      ->required()
      ->type_name("OUT.h5");
  add_overrides(command, arguments);
  add_reporting(command, arguments);
}

void add_check(CLI::App& app, Arguments& arguments) {
  CLI::App& command =
      *app.add_subcommand("check", "validate a case; print resolved and derived values");
  command.add_option("case", arguments.file, "case file")->required()->type_name("CASE.toml");
  add_overrides(command, arguments);
}

void add_info(CLI::App& app, Arguments& arguments) {
  CLI::App& command =
      *app.add_subcommand("info", "print the summary of a finished or interrupted run");
  command.add_option("file", arguments.file, "output file of a run")
      ->required()
      ->type_name("OUT.h5");
  command.add_flag("--json", arguments.json, "print it as one JSON object");
}

void add_adjudicate(CLI::App& app, Arguments& arguments) {
  CLI::App& command = *app.add_subcommand(
      "adjudicate", "physics or rounding: replay a collapse with more digits and other rules");
  command.add_option("file", arguments.file, "output file of a run, or a case file")
      ->required()
      ->type_name("OUT.h5|CASE.toml");
  const std::map<std::string, Precision> ladder{{"double", Precision::double_precision},
                                                {"extended", Precision::extended},
                                                {"quad", Precision::quad},
                                                {"digits100", Precision::digits100}};
  command.add_option("--up-to", arguments.up_to, "highest precision to try")
      ->transform(CLI::CheckedTransformer(ladder))
      ->type_name("PRECISION")
      ->default_str("digits100");
  command.add_option("--collisions", arguments.collisions, "of each trial after the first hit")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1} << 52))
      ->capture_default_str();
  add_overrides(command, arguments);
  command.add_flag("--json", arguments.json, "print the result as one JSON object");
  command.add_flag("--quiet", arguments.quiet, "no progress, no table for people");
}

void add_verify(CLI::App& app, Arguments& arguments) {
  CLI::App& command = *app.add_subcommand(
      "verify", "re-check a finished file: replay the collision log against the snapshots");
  command.add_option("file", arguments.file, "output file of a run")
      ->required()
      ->type_name("OUT.h5");
}

}  // namespace

int run_command_line(int argc, char** argv) {
  CLI::App app(
      "Event-driven inelastic hard spheres under shear: did it collapse, or the arithmetic?",
      "zenosphere");
  app.set_version_flag("--version", std::string("zenosphere ") + build_info::program_version +
                                        " (" + build_info::git_hash + ")");
  app.require_subcommand(1);
  Arguments arguments;
  add_run(app, arguments);
  add_resume(app, arguments);
  add_check(app, arguments);
  add_info(app, arguments);
  add_adjudicate(app, arguments);
  add_verify(app, arguments);
  try {
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
  if (app.got_subcommand("run")) return run(arguments);
  if (app.got_subcommand("resume")) return resume(arguments);
  if (app.got_subcommand("adjudicate")) return adjudicate(arguments);
  if (app.got_subcommand("check")) return check(arguments);
  if (app.got_subcommand("verify")) return verify_output(arguments);
  return info(arguments);
}

}  // namespace zenosphere
