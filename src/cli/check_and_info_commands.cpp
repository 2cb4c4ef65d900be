#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "case/case_file.hpp"
#include "cli/case_input.hpp"
#include "cli/command.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "start/derived.hpp"
#include "storage/info.hpp"
#include "storage/integrity.hpp"

namespace zenosphere {

namespace {

/// What the user typed.
struct CheckArguments {
  std::string file;
  std::vector<std::string> overrides;
  bool json = false;
};

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

int check(const CheckArguments& arguments) {
  const Case values = case_from(arguments.file, arguments.overrides);
  print(resolved_toml(values) + '\n' + as_comments(derived_text(values)));
  return exit_code::done;
}

int info(const CheckArguments& arguments) {
  constexpr std::uintmax_t most_read = 1 << 30;  // a second or a few
  std::error_code ignored;
  const auto bytes = std::filesystem::file_size(arguments.file, ignored);
  const bool is_read = ignored || bytes <= most_read;
  const Integrity integrity = is_read ? checked_integrity(arguments.file) : Integrity::unread;
  OutputInfo info = read_output_info(arguments.file);
  info.integrity = integrity;
  print(arguments.json ? to_json(info) + '\n' : to_text(info, arguments.file));
  return exit_code::done;
}

}  // namespace

void add_check(CLI::App& app, int& status) {
  const auto arguments = std::make_shared<CheckArguments>();
  CLI::App& command =
      *app.add_subcommand("check", "validate a case; print resolved and derived values");
  command.add_option("case", arguments->file, "case file; - is the standard input")
      ->required()
      ->type_name("CASE.toml");
  add_overrides(command, arguments->overrides);
  command.callback([arguments, &status] { status = check(*arguments); });
}

void add_info(CLI::App& app, int& status) {
  const auto arguments = std::make_shared<CheckArguments>();
  CLI::App& command =
      *app.add_subcommand("info", "print the summary of a finished or interrupted run");
  command.add_option("file", arguments->file, "output file of a run")
      ->required()
      ->type_name("OUT.h5");
  command.add_flag("--json", arguments->json, "print it as one JSON object");
  command.callback([arguments, &status] { status = info(*arguments); });
}

}  // namespace zenosphere
