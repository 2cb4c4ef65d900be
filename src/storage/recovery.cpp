#include "storage/recovery.hpp"

#include <fmt/format.h>

#include <utility>

#include "model/errors.hpp"
#include "storage/integrity.hpp"
#include "storage/stored_info.hpp"

namespace zenosphere {
namespace {

namespace fs = std::filesystem;

Journal locked_journal(const fs::path& path, const fs::path& target) {
  try {
    return Journal(target);
  } catch (const SystemError& error) {
    throw OutputError(
        fmt::format("{}: cannot be resumed ({}: {}); copy it to a place where you may write",
                    path.string(), journal_of(target).filename().string(), error.what()));
  }
}

/// Takes from the journal what is newer than the HDF5 file.
void read_journal(RecoveredOutput& output) {
  if (output.journal.size() == 0) return;
  try {
    const JournalReader reader(output.journal.file());
    if (reader.basis() != output.basis) return output.journal.clear();  // void: folded in already
    JournalContents contents = contents_of(output.journal.file(), Thoroughness::every_byte);
    output.journal.continue_after(output.basis, contents);
    if (contents.checkpoint) output.checkpoint = *std::move(contents.checkpoint);
    if (contents.resolved_case) output.info.resolved_case = *std::move(contents.resolved_case);
  } catch (const SystemError& error) {
    throw OutputError(fmt::format("{}: {}; check the disk it is on", output.journal.path().string(),
                                  error.what()));
  } catch (const ArchiveError& error) {
    throw InputError(fmt::format(
        "{}: is {}; delete it to resume from the checkpoint in {} itself, at collision {}",
        output.journal.path().string(), error.what(), output.path.filename().string(),
        output.checkpoint.collisions));
  }
}

}  // namespace

fs::path part_of(const fs::path& output) {
  fs::path name = output;
  name += ".part";
  return name;
}

RecoveredOutput recover(const fs::path& path) {
  checked_integrity(path);  // damage must not get checksums of its own
  read_output_info(path);   // what is no output gets no journal
  std::error_code ignored;
  const fs::path target = fs::is_symlink(path, ignored) ? fs::canonical(path, ignored) : path;
  Journal journal = locked_journal(path, target);
  Checkpoint checkpoint = read_checkpoint(target);
  const Basis basis = Basis::of(checkpoint);
  RecoveredOutput output{
      path, target, std::move(journal), read_output_info(path), basis, std::move(checkpoint)};
  fs::remove(part_of(target), ignored);
  read_journal(output);
  return output;
}

}  // namespace zenosphere
