#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace zenosphere {

// Each of these adds a command to the program. When the user types it, it does its work while the
// command line is parsed and leaves its exit code in `status`; what it throws goes to the
// caller.

void add_run(CLI::App& app, int& status);
void add_resume(CLI::App& app, int& status);
void add_check(CLI::App& app, int& status);
void add_info(CLI::App& app, int& status);
void add_adjudicate(CLI::App& app, int& status);
void add_verify(CLI::App& app, int& status);
void add_sweep(CLI::App& app, int& status);
/// The commands below `sweep` that look at a sweep without running it.
void add_sweep_show_and_csv(CLI::App& sweep, int& status);
void add_export(CLI::App& app, int& status);
void add_report(CLI::App& app, int& status);
void add_new(CLI::App& app, int& status);
void add_examples(CLI::App& app, int& status);
void add_completion(CLI::App& app, int& status);
void add_manual(CLI::App& app, int& status);
/// The commands of the Python package; these replace the program and do not come back.
void add_python_commands(CLI::App& app);

/// Adds `--set KEY=VALUE`, which may be given any number of times.
void add_overrides(CLI::App& command, std::vector<std::string>& overrides);

}  // namespace zenosphere
