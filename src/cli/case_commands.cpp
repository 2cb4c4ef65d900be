#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/outputs.hpp"
#include "cli/shipped_cases.hpp"
#include "cli/values.hpp"
#include "model/errors.hpp"
#include "storage/text_target.hpp"
#include "text/spelling.hpp"

namespace zenosphere {

namespace {

constexpr std::string_view folder_of_questions = "new/";

/// What the user typed.
struct CaseArguments {
  std::optional<std::string> name;
  std::optional<std::string> output;
  std::optional<std::string> folder;
  bool overwrite = false;
};

bool is_question(const ShippedCase& shipped) {
  return shipped.name.starts_with(folder_of_questions);
}

/// A line for each case: its name, from `prefix` on, and its title.
std::string listing(const std::vector<ShippedCase>& cases, std::size_t prefix, std::size_t width) {
  std::string text;
  for (const ShippedCase& shipped : cases) {
    std::string name(shipped.name.substr(prefix));
    name.resize(width, ' ');
    text += fmt::format("  {}  {}\n", name, title_of(shipped));
  }
  return text;
}

std::size_t longest_name(const std::vector<ShippedCase>& cases) {
  std::size_t width = 0;
  for (const ShippedCase& shipped : cases) width = std::max(width, shipped.name.size());
  return width;
}

std::string list_of_questions() {
  std::vector<ShippedCase> questions;
  for (const ShippedCase& shipped : shipped_cases()) {
    if (is_question(shipped)) questions.push_back(shipped);
  }
  const std::size_t prefix = folder_of_questions.size();
  return listing(questions, prefix, longest_name(questions) - prefix);
}

/// The examples by subject, the simplest first.
std::string list_of_examples() {
  std::size_t width = 0;
  for (const ExampleGroup& group : example_groups()) {
    width = std::max(width, longest_name(group.cases));
  }
  std::string text;
  for (const ExampleGroup& group : example_groups()) {
    text += fmt::format("\n{}\n{}", group.heading, listing(group.cases, 0, width));
  }
  return text;
}

/// The names that `new` or `examples` takes.
std::vector<std::string> names_of(const std::string& command) {
  const bool is_new = command == "new";
  std::vector<std::string> names;
  for (const ShippedCase& shipped : shipped_cases()) {
    if (is_question(shipped) != is_new) continue;
    names.emplace_back(shipped.name.substr(is_new ? folder_of_questions.size() : 0));
  }
  return names;
}

const ShippedCase& case_named(const std::string& name, const std::string& typed,
                              const std::string& command) {
  const auto shipped = shipped_cases();
  const auto found = std::find_if(shipped.begin(), shipped.end(),
                                  [&](const ShippedCase& one) { return one.name == name; });
  if (found != shipped.end()) return *found;
  const std::vector<std::string> names = names_of(command);
  const std::vector<std::string_view> known(names.begin(), names.end());
  const auto meant = nearest(typed, known);
  throw InputError(fmt::format(
      "zenosphere {}: no case is called {}; {}run zenosphere {} for the "
      "list",
      command, typed, meant ? fmt::format("did you mean {}? Else ", *meant) : "", command));
}

void write_case(const std::filesystem::path& file, std::string_view text, bool overwrite) {
  std::error_code ignored;  // the file tells what is wrong
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), ignored);
  TextTarget target(file, overwrite ? Existing::replace : Existing::refuse);
  target.file().write(text);
  target.finish();
}

/// Writes a case where the user wants it, and says what to do with it.
void hand_out(const ShippedCase& shipped, const std::string& file, bool overwrite) {
  require_name(file);
  if (is_standard_output(file)) return print(std::string(shipped.text));
  write_case(file, shipped.text, overwrite);
  const std::string stem = std::filesystem::path(file).stem().string();
  const bool is_sweep = shipped.text.find("\n[sweep]") != std::string_view::npos;
  print(is_sweep ? fmt::format("{0}: {1}.\nzenosphere sweep {0} --dry-run shows its plan\n", file,
                               title_of(shipped))
                 : fmt::format("{0}: {1}\nzenosphere run {0} -o {2}.h5 runs it\n", file,
                               title_of(shipped), stem));
}

int new_case(const CaseArguments& arguments) {
  if (!arguments.name) {
    print("zenosphere new NAME writes a commented case to start from, NAME.toml:\n" +
          list_of_questions());
    return exit_code::done;
  }
  const std::string name = std::string(folder_of_questions) + *arguments.name;
  hand_out(case_named(name, *arguments.name, "new"),
           arguments.output.value_or(*arguments.name + ".toml"), arguments.overwrite);
  return exit_code::done;
}

void copy_all(const std::filesystem::path& folder, bool overwrite) {
  std::size_t copied = 0;
  for (const ShippedCase& shipped : shipped_cases()) {
    write_case(folder / (std::string(shipped.name) + ".toml"), shipped.text, overwrite);
    ++copied;
  }
  print(fmt::format("{}: {} case and sweep files\n", folder.string(), copied));
}

int examples(const CaseArguments& arguments) {
  if (arguments.folder) {
    require_name(*arguments.folder);
    copy_all(*arguments.folder, arguments.overwrite);
  } else if (arguments.name) {
    const std::string file = std::filesystem::path(*arguments.name).filename().string() + ".toml";
    hand_out(case_named(*arguments.name, *arguments.name, "examples"),
             arguments.output.value_or(file), arguments.overwrite);
  } else {
    print("zenosphere examples NAME copies one, zenosphere examples --all FOLDER all of them:\n" +
          list_of_examples());
  }
  return exit_code::done;
}

}  // namespace

void add_new(CLI::App& app, int& status) {
  const auto arguments = std::make_shared<CaseArguments>();
  CLI::App& command = *app.add_subcommand("new", "write a commented case to start from");
  command.add_option("name", arguments->name, "the question; without it: the list of them")
      ->check(such_as(names_of("new")))
      ->type_name("NAME");
  command.add_option("-o,--output", arguments->output, "file to write; default: NAME.toml")
      ->type_name("CASE.toml");
  command.add_flag("--overwrite", arguments->overwrite, "replace what is there");
  command.callback([arguments, &status] { status = new_case(*arguments); });
}

void add_examples(CLI::App& app, int& status) {
  const auto arguments = std::make_shared<CaseArguments>();
  CLI::App& command = *app.add_subcommand("examples", "list the shipped cases, or copy them");
  const auto name =
      command.add_option("name", arguments->name, "one to copy; without it: the list of them")
          ->check(such_as(names_of("examples")))
          ->type_name("NAME");
  const auto output =
      command.add_option("-o,--output", arguments->output, "file to write; default: NAME.toml")
          ->type_name("CASE.toml");
  command.add_option("--all", arguments->folder, "copy all of them into this folder")
      ->type_name("FOLDER")
      ->excludes(name)
      ->excludes(output);
  command.add_flag("--overwrite", arguments->overwrite, "replace what is there");
  command.callback([arguments, &status] { status = examples(*arguments); });
}

}  // namespace zenosphere
