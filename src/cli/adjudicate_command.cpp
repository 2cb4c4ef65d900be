#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "case/case_file.hpp"
#include "cli/case_input.hpp"
#include "cli/command.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/interrupt.hpp"
#include "cli/values.hpp"
#include "model/errors.hpp"
#include "run/adjudicate.hpp"
#include "storage/integrity.hpp"
#include "storage/keep_adjudication.hpp"
#include "storage/output_info.hpp"

namespace zenosphere {

namespace {

/// What the user typed.
struct AdjudicateArguments {
  std::string file;
  std::vector<std::string> overrides;
  bool json = false;
  bool quiet = false;
  std::optional<Precision> up_to{};
  std::optional<std::int64_t> collisions{};
  std::optional<std::int64_t> groups{};
  double seconds = AdjudicationLimits().seconds;
};

int adjudicate(const AdjudicateArguments& arguments) {
  const bool is_output = is_hdf5_file(arguments.file);
  if (is_output) checked_integrity(arguments.file);
  const Case values = is_output ? parse_case(read_output_info(arguments.file).resolved_case,
                                             arguments.file, arguments.overrides)
                                : case_from(arguments.file, arguments.overrides);
  AdjudicationLimits limits{.highest = arguments.up_to,
                            .collisions = arguments.collisions,
                            .groups = arguments.groups,
                            .seconds = arguments.seconds,
                            .interrupt = &catch_signals()};
  if (!arguments.quiet && is_terminal()) {
    limits.on_trial = show_line;
  }
  const Adjudication result = adjudicate(values, limits);
  if (limits.on_trial) clear_line();
  const bool has_found =
      !result.is_without_hits && (!result.was_interrupted || !result.approaches.empty());
  const bool is_of_file = is_output && arguments.overrides.empty();  // with --set: of another run
  if (is_of_file && has_found) keep_adjudication(arguments.file, to_json(result));
  if (!arguments.quiet) print(to_text(result));
  if (arguments.json) print(to_json(result) + '\n');
  return result.was_interrupted ? exit_code::interrupted : exit_code::done;
}

}  // namespace

void add_adjudicate(CLI::App& app, int& status) {
  const auto arguments = std::make_shared<AdjudicateArguments>();
  CLI::App& command = *app.add_subcommand(
      "adjudicate", "physics or rounding: replay a collapse with more digits and other rules");
  command.add_option("file", arguments->file, "output file of a run, or a case file")
      ->required()
      ->type_name("OUT.h5|CASE.toml");
  const auto read_precision = [arguments](const std::string& word) {
    arguments->up_to = Precision::from_word(word);
    if (arguments->up_to) return;
    const bool is_number = Precision::from_word("digits" + word).has_value();
    throw InputError(fmt::format(
        "--up-to = {} (must be double, extended, quad or digitsN with N from {} to "
        "{}){}",
        word, fewest_digits, most_digits, is_number ? fmt::format("; write digits{}", word) : ""));
  };
  command
      .add_option_function<std::string>(
          "--up-to", read_precision,
          "highest precision to try; default: digits100, and more while digits run out")
      ->check(such_as({"double", "extended", "quad", "digits100"}))
      ->type_name("PRECISION");
  command
      .add_option(
          "--collisions", arguments->collisions,
          "longest trial, counted from the run's hit; default: until the digits are spent or "
          "the spheres have flown apart")
      ->check(whole_number("--collisions", 1, most_typed));
  command
      .add_option("--groups", arguments->groups,
                  "follow only the first N groups of hits; default: all")
      ->check(whole_number("--groups", 1, most_typed));
  command.add_option("--seconds", arguments->seconds, "budget for all of it, in seconds")
      ->check(positive_number("--seconds"))
      ->capture_default_str();
  add_overrides(command, arguments->overrides);
  command.add_flag("--json", arguments->json, "print the result as one JSON object");
  command.add_flag("--quiet", arguments->quiet, "no progress, no table for people");
  command.callback([arguments, &status] { status = adjudicate(*arguments); });
}

}  // namespace zenosphere
