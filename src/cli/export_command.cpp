#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/interrupt.hpp"
#include "cli/outputs.hpp"
#include "cli/values.hpp"
#include "export/export_run.hpp"
#include "storage/text_target.hpp"
#include "text/printable.hpp"

namespace zenosphere {

namespace {

std::vector<std::string> names_of_formats() {
  std::vector<std::string> names;
  for (const ExportFormat& format : export_formats()) names.emplace_back(format.word);
  std::sort(names.begin(), names.end());
  return names;
}

/// `extxyz (OVITO, ASE), lammps (...) or ...`
std::string help_on_formats() {
  std::string text;
  const auto formats = export_formats();
  for (const ExportFormat& format : formats) {
    if (!text.empty()) text += &format == &formats.back() ? " or " : ", ";
    text += format.word;
    if (!format.read_by.empty()) text += " (" + std::string(format.read_by) + ')';
  }
  return text;
}

/// What the user typed.
struct ExportArguments {
  std::string file;
  std::string target;
  std::string format;
  Selection selection;
  bool overwrite = false;
  bool quiet = false;
};

int export_output(const ExportArguments& arguments) {
  require_name(arguments.target);
  const Export request{.run = arguments.file,
                       .target = arguments.target,
                       .format = export_format(arguments.format),
                       .selection = arguments.selection,
                       .existing = arguments.overwrite ? Existing::replace : Existing::refuse,
                       .interrupt = &catch_signals()};
  const Exported exported = export_run(request);
  const std::string text = arguments.quiet ? "" : printable(to_text(exported, request));
  is_standard_output(request.target) ? print_aside(text) : print(text);
  return exported.interrupted ? exit_code::interrupted : exit_code::done;
}

void add_selection(CLI::App& command, Selection& selection) {
  command
      .add_option("--from", selection.from,
                  "first snapshot, counted from 0, -1 is the last; for csv-collisions: first "
                  "collision")
      ->check(whole_number("--from", -most_typed, most_typed))
      ->capture_default_str();
  command.add_option("--to", selection.to, "last one, likewise; without: the last there is")
      ->check(whole_number("--to", -most_typed, most_typed));
  command.add_option("--every", selection.every, "every Nth snapshot or collision")
      ->check(whole_number("--every", 1, most_typed))
      ->capture_default_str();
}

}  // namespace

void add_export(CLI::App& app, int& status) {
  const auto arguments = std::make_shared<ExportArguments>();
  CLI::App& command =
      *app.add_subcommand("export", "write the snapshots or tables of a run for other programs");
  command.add_option("file", arguments->file, "output file of a run")
      ->required()
      ->type_name("OUT.h5");
  command.add_option("--format", arguments->format, help_on_formats())
      ->required()
      ->check(one_of("--format", names_of_formats()))
      ->type_name("FORMAT");
  command
      .add_option("-o,--output", arguments->target, "file to write; - writes to standard output")
      ->required()
      ->type_name("FILE");
  add_selection(command, arguments->selection);
  command.add_flag("--overwrite", arguments->overwrite, "replace what is there");
  command.add_flag("--quiet", arguments->quiet, "print nothing");
  command.callback([arguments, &status] { status = export_output(*arguments); });
}

}  // namespace zenosphere
