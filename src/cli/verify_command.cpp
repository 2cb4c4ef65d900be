#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "cli/command.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "text/printable.hpp"
#include "verify/verify.hpp"

namespace zenosphere {

namespace {

int verify_output(const std::string& file) {
  const Verification verification = verify_file(file);
  print(printable(to_text(verification, file)));
  return verification.findings.count() == 0 ? exit_code::done : exit_code::wrong_input;
}

}  // namespace

void add_verify(CLI::App& app, int& status) {
  const auto file = std::make_shared<std::string>();
  CLI::App& command = *app.add_subcommand(
      "verify", "re-check a finished file: replay the collision log against the snapshots");
  command.add_option("file", *file, "output file of a run")->required()->type_name("OUT.h5");
  command.callback([file, &status] { status = verify_output(*file); });
}

}  // namespace zenosphere
