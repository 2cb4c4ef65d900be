#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "campaign/estimate.hpp"
#include "campaign/mpi_environment.hpp"
#include "campaign/mpi_workers.hpp"
#include "campaign/search.hpp"
#include "campaign/thread_workers.hpp"
#include "cli/command.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/interrupt.hpp"
#include "cli/outputs.hpp"
#include "cli/search_text.hpp"
#include "cli/sweep_text.hpp"
#include "cli/values.hpp"
#include "storage/build_info.hpp"

namespace zenosphere {

namespace {

/// What the user typed.
struct SweepArguments {
  std::string file;
  std::optional<std::string> store;
  std::optional<std::size_t> threads;
  bool dry_run = false;
  bool retry_failed = false;
  bool json = false;
  bool quiet = false;
};

/// The sweep file's name with another ending, in the current folder.
std::string store_of(const SweepArguments& arguments) {
  if (arguments.store) return *arguments.store;
  return std::filesystem::path(arguments.file).filename().replace_extension(".sqlite").string();
}

/// Those who do the runs: so many of them, made once the store tells what they share.
struct Crew {
  std::size_t size;
  std::string kind;  ///< `threads`
  std::function<std::unique_ptr<Workers>(RunSetting)> make;
};

int show_plan(const SweepArguments& arguments, const Sweep& sweep, const Crew& crew) {
  const std::string store = store_of(arguments);
  std::error_code ignored;
  const bool is_there = std::filesystem::exists(store, ignored);
  const SweepPlan plan =
      plan_of(sweep, is_there ? std::optional(store) : std::nullopt, &catch_signals());
  print(arguments.json ? plan_json(sweep, plan, crew.size) + '\n'
                       : plan_text(sweep, plan, crew.size, crew.kind));
  return exit_code::done;
}

void tell_of_other_program(const SweepStore& store) {
  const StoredSweep& sweep = store.sweep();
  if (sweep.git_hash == build_info::git_hash) return;
  fmt::print(stderr,
             "{}: was begun by zenosphere {} ({}), this is {} ({}); each run tells which one did "
             "it\n",
             store.name(), sweep.program_version, sweep.git_hash, build_info::program_version,
             build_info::git_hash);
}

int exit_code_of(const SweepProgress& progress) {
  if (progress.counts.left() > 0) return exit_code::interrupted;
  return progress.counts.failed > 0 ? exit_code::internal_error : exit_code::done;
}

int run_runs(const SweepArguments& arguments, const Sweep& sweep, const Crew& crew) {
  SweepOptions options{.interrupt = &catch_signals()};
  SweepStore store(store_of(arguments), sweep);
  tell_of_other_program(store);
  if (arguments.retry_failed) store.forget_failures();
  const bool shows_line = !arguments.quiet && is_terminal();
  if (shows_line) {
    options.on_progress = [](const SweepProgress& progress) {
      show_line(sweep_line(progress, terminal_columns()));
    };
  }
  const auto workers = crew.make(store.setting());
  SearchResult result;
  if (sweep.boundary) {
    result = run_search(store, sweep, *workers, options);
  } else {
    result.progress = run_sweep(store, *workers, options);
  }
  const SweepProgress& progress = result.progress;
  if (shows_line) clear_line();
  if (!arguments.quiet) print(progress_text(progress, store.name()) + found_text(sweep, result));
  if (arguments.json) print(progress_json(progress, store.name()) + '\n');
  return exit_code_of(progress);
}

int sweep(const SweepArguments& arguments, const Crew& crew) {
  const Sweep sweep = read_sweep(arguments.file);
  return arguments.dry_run ? show_plan(arguments, sweep, crew) : run_runs(arguments, sweep, crew);
}

int sweep_in_threads(const SweepArguments& arguments) {
  const std::size_t threads = arguments.threads.value_or(usable_cores());
  return sweep(arguments, {threads, "threads", [threads](RunSetting setting) {
                             return std::make_unique<ThreadWorkers>(std::move(setting), threads);
                           }});
}

int sweep_in_ranks(const SweepArguments& arguments) {
  const MpiSession session;
  if (session.rank() != 0) {
    serve_runs(session, catch_signals());
    return exit_code::done;
  }
  if (session.size() == 1) {
    throw InputError(fmt::format(
        "sweep: started as one of {} processes, but MPI sees only this one (a launcher of another "
        "MPI); start it with the mpirun of the MPI it was built with, or srun --mpi=pmix",
        ranks_in_environment()));
  }
  if (arguments.threads) {
    throw InputError("--threads: is not for several processes (each has one); remove it");
  }
  return sweep(arguments, {static_cast<std::size_t>(session.size() - 1), "ranks",
                           [&session](RunSetting setting) {
                             return std::make_unique<MpiWorkers>(session, std::move(setting));
                           }});
}

int sweep(const SweepArguments& arguments) {
  if (arguments.file.empty()) {
    throw InputError("sweep: which one? (no file is named); write zenosphere sweep SWEEP.toml");
  }
  if (arguments.store) require_file_name(*arguments.store, "a store is a database");
  return ranks_in_environment() > 1 ? sweep_in_ranks(arguments) : sweep_in_threads(arguments);
}

/// What a store holds is what its sweep file tells.
void refuse_overrides(const std::vector<std::string>& overrides) {
  throw InputError(fmt::format(
      "--set {}: is not for sweeps (a store holds the runs of one sweep file); write it "
      "into the base case, or under [case...] or [axes] of the sweep file",
      overrides.front()));
}

}  // namespace

void add_sweep(CLI::App& app, int& status) {
  const auto arguments = std::make_shared<SweepArguments>();
  CLI::App& command = *app.add_subcommand(
      "sweep", "run an ensemble over a grid of keys and seeds into one SQLite store");
  command.add_option("file", arguments->file, "sweep file")->type_name("SWEEP.toml");
  command.add_option("-o,--output", arguments->store, "the store; default: the file's name")
      ->type_name("STORE.sqlite");
  command.add_option("--threads", arguments->threads, "runs at the same time; default: all cores")
      ->check(whole_number("--threads", 1, 1024));
  command.add_option_function<std::vector<std::string>>("--set", refuse_overrides)
      ->group("");  // no option, but what many try
  command.add_flag("--dry-run", arguments->dry_run, "print the plan and how long it would take");
  command.add_flag("--retry-failed", arguments->retry_failed, "run again what has failed");
  command.add_flag("--json", arguments->json, "print what came out as one JSON object");
  command.add_flag("--quiet", arguments->quiet, "no progress line, no summary for people");
  add_sweep_show_and_csv(command, status);
  command.callback([&command, arguments, &status] {
    if (command.get_subcommands().empty()) status = sweep(*arguments);
  });
}

}  // namespace zenosphere
