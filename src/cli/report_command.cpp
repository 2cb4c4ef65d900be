#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>

#include "campaign/database.hpp"
#include "cli/command.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/outputs.hpp"
#include "report/run_page.hpp"
#include "report/sweep_page.hpp"
#include "storage/journal.hpp"
#include "text/printable.hpp"

namespace zenosphere {

namespace {

/// What the user typed.
struct ReportArguments {
  std::string file{};
  std::optional<std::string> typed_page{};
  std::string page{};
  bool overwrite = false;
  bool quiet = false;
};

/// `page.html: report page of out.h5, 1.2 MB; open it in a browser`
std::string written_text(const ReportArguments& arguments, bool is_sweep) {
  std::error_code ignored;  // it was written a moment ago
  const auto bytes = static_cast<double>(std::filesystem::file_size(arguments.page, ignored));
  return fmt::format("{}: {} {}, {:.1f} MB; open it in a browser\n", arguments.page,
                     is_sweep ? "phase diagrams of the sweep" : "report page of the run",
                     arguments.file, bytes / 1e6);
}

/// run.html beside run.h5.
std::string page_beside(const std::string& file) {
  return std::filesystem::path(file).replace_extension(".html").string();
}

int report(ReportArguments& arguments) {
  arguments.page = arguments.typed_page.value_or(page_beside(arguments.file));
  require_file_name(arguments.page, "a page is megabytes of HTML for a browser");
  for (const auto& shown : {std::filesystem::path(arguments.file), journal_of(arguments.file)}) {
    require_other_than(shown, arguments.page, "what it is to show");
  }
  const auto existing = arguments.overwrite ? Existing::replace : Existing::refuse;
  const bool is_sweep = is_database(arguments.file);
  (is_sweep ? write_sweep_page : write_run_page)(arguments.file, arguments.page, existing);
  if (!arguments.quiet) print(printable(written_text(arguments, is_sweep)));
  return exit_code::done;
}

}  // namespace

void add_report(CLI::App& app, int& status) {
  const auto arguments = std::make_shared<ReportArguments>();
  CLI::App& command = *app.add_subcommand(
      "report", "make one HTML page that shows a run, or the phase diagrams of a sweep");
  command.add_option("file", arguments->file, "output file of a run, or store of a sweep")
      ->required()
      ->type_name("OUT.h5|STORE.sqlite");
  command
      .add_option("-o,--output", arguments->typed_page,
                  "the page; without it beside the file, with the ending .html")
      ->type_name("PAGE.html");
  command.add_flag("--overwrite", arguments->overwrite, "replace an existing page");
  command.add_flag("--quiet", arguments->quiet, "print nothing");
  command.callback([arguments, &status] { status = report(*arguments); });
}

}  // namespace zenosphere
