#include "campaign/show.hpp"

#include <fmt/format.h>

#include "campaign/run_case.hpp"
#include "campaign/store.hpp"
#include "case/case_file.hpp"
#include "text/printable.hpp"

namespace zenosphere {

namespace {

std::string text_of(const Case& values, const std::string& file, std::int64_t run) {
  return fmt::format("# Run {} of {}\n\n", run, printable(file)) + resolved_toml(values);
}

}  // namespace

std::string case_text_of_run(const std::string& file, std::int64_t run) {
  if (is_database(file)) {
    Database database(file, Database::Access::read);
    const StoredSweep sweep = stored_sweep(database);
    const RunTask task = StoredRuns(database, sweep).run(run);
    return text_of(case_of_run(sweep.base, sweep.stop, task.overrides), file, run);
  }
  const Sweep sweep = read_sweep(file);
  if (sweep.boundary) {
    throw InputError(
        fmt::format("{}: describes a search (its runs follow from results); give its store", file));
  }
  if (run < 0 || run >= sweep.runs()) {
    throw InputError(
        fmt::format("--run {}: there is no such run in {} (0 to {})", run, file, sweep.runs() - 1));
  }
  return text_of(case_of_run(sweep.base, sweep.stop, overrides_of(sweep, run)), file, run);
}

}  // namespace zenosphere
