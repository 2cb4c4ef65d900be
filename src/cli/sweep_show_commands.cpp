#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "campaign/csv.hpp"
#include "campaign/show.hpp"
#include "campaign/stored_sweep.hpp"
#include "cli/command.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/outputs.hpp"
#include "cli/values.hpp"
#include "storage/text_target.hpp"

namespace zenosphere {

namespace {

/// What the user typed.
struct SweepShowArguments {
  std::string file;
  std::int64_t run = 0;
  std::optional<std::string> output;
};

int show(const SweepShowArguments& arguments) {
  print(case_text_of_run(arguments.file, arguments.run));
  return exit_code::done;
}

int csv(const SweepShowArguments& arguments) {
  const std::string output = arguments.output.value_or("-");
  require_name(output);
  require_other_than(arguments.file, output, "the store itself");
  Database database(arguments.file, Database::Access::read);
  stored_sweep(database);
  TextTarget target(output, Existing::replace);  // it can always be made again
  write_csv(database, [&](const std::string& text) { target.file().write(text); });
  target.finish();
  return exit_code::done;
}

}  // namespace

void add_sweep_show_and_csv(CLI::App& command, int& status) {
  const auto arguments = std::make_shared<SweepShowArguments>();
  CLI::App& show_command =
      *command.add_subcommand("show", "print the case file of one run, for zenosphere run");
  show_command.add_option("file", arguments->file, "sweep file or store")
      ->required()
      ->type_name("SWEEP.toml|STORE.sqlite");
  show_command.add_option("--run", arguments->run, "its number, from 0")
      ->required()
      ->check(whole_number("--run", 0, most_typed))
      ->type_name("N");
  show_command.callback([arguments, &status] { status = show(*arguments); });

  CLI::App& csv_command = *command.add_subcommand("csv", "write all rows of a store as CSV");
  csv_command.add_option("file", arguments->file, "store of a sweep")
      ->required()
      ->type_name("STORE.sqlite");
  csv_command
      .add_option("-o,--output", arguments->output,
                  "write them here; - and without: to standard output")
      ->type_name("FILE.csv");
  csv_command.callback([arguments, &status] { status = csv(*arguments); });
}

}  // namespace zenosphere
