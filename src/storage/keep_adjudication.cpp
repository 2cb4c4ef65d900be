#include "storage/keep_adjudication.hpp"

#include <fmt/format.h>

#include "model/errors.hpp"
#include "storage/durable.hpp"
#include "storage/hdf5.hpp"
#include "storage/integrity.hpp"
#include "storage/recovery.hpp"

namespace zenosphere {

void keep_adjudication(const std::filesystem::path& output, const std::string& json) {
  RecoveredOutput run = recover(output);  // locks it by a journal
  const bool has_ended = run.info.complete && run.journal.size() == 0;
  if (has_ended) run.journal.remove();
  if (!has_ended) {
    throw InputError(
        fmt::format("{}: its run has not ended; zenosphere resume {} first, then adjudicate again",
                    output.string(), output.string()));
  }
  const std::filesystem::path part = part_of(run.target);
  try {
    clone_file(run.target, part);
    {
      const hdf5::Handle file = hdf5::reopened_file(part);
      const hdf5::Handle own = hdf5::opened(file, "zenosphere");
      hdf5::remove(own, "adjudication");
      hdf5::write_text(own, "adjudication", json);
      write_checksums(file);
    }
    seal(part);
    put_in_place(part, run.target);
  } catch (const std::exception& error) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw OutputError(
        fmt::format("{}: the adjudication could not be stored ({}); the file is as it was",
                    output.string(), error.what()));
  }
}

}  // namespace zenosphere
