#include "campaign/start_files.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "model/errors.hpp"
#include "storage/durable.hpp"
#include "storage/file_checksum.hpp"

namespace zenosphere {
namespace {

/// A file as runs find it.
struct StartFile {
  std::string name;  ///< absolute
  std::int64_t bytes = 0;
  std::int64_t checksum = 0;  ///< CRC-32C
};

bool has_axis(const Sweep& sweep) {
  return std::ranges::any_of(sweep.axes,
                             [](const SweepAxis& axis) { return axis.path() == "start.file"; });
}

std::vector<std::string> names_in(const Sweep& sweep) {
  std::vector<std::string> names;
  const auto add = [&names](const case_format::Value& value) {
    if (const auto* name = std::get_if<std::string>(&value)) names.push_back(*name);
  };
  for (const SweepAxis& axis : sweep.axes) {
    if (axis.path() != "start.file") continue;
    for (const AxisValue& value : axis.values) add(value.value);
  }
  for (const case_format::Entry& entry : case_format::entries_of(sweep.base_text, sweep.name)) {
    if (entry.key() == "start.file") add(entry.value);
  }
  return names;
}

std::optional<StartFile> found_at(const std::string& name) {
  try {
    const FileDescriptor file(name, O_RDONLY);
    const std::uint64_t bytes = size_of(file);
    return StartFile{name, static_cast<std::int64_t>(bytes), file_checksum(file, bytes)};
  } catch (const SystemError&) {
    return std::nullopt;
  }
}

/// Whether the store knows the file with another content.
bool has_changed(Database& database, const StartFile& file) {
  Statement query = database.statement("SELECT bytes, checksum FROM start_file WHERE name = ?");
  query.start(std::array<Cell, 1>{file.name});
  return query.step() &&
         (query.cell(0) != Cell(file.bytes) || query.cell(1) != Cell(file.checksum));
}

/// Whether a run that is done has started from the file.
bool is_used(Database& database, const StartFile& file, const Sweep& sweep) {
  if (!has_axis(sweep)) {
    return database.integer("SELECT count(*) FROM run WHERE status = 'done'") > 0;
  }
  Statement query =
      database.statement("SELECT 1 FROM run WHERE status = 'done' AND \"start.file\" = ? LIMIT 1");
  query.start(std::array<Cell, 1>{file.name});
  return query.step();
}

}  // namespace

void keep_start_files(Database& database, const Sweep& sweep) {
  const std::vector<std::string> names = names_in(sweep);
  if (names.empty()) return;
  database.execute(
      "CREATE TABLE IF NOT EXISTS start_file (name TEXT PRIMARY KEY, bytes INTEGER NOT NULL, "
      "checksum INTEGER NOT NULL)");
  Statement keep = database.statement(
      "INSERT OR REPLACE INTO start_file (name, bytes, checksum) VALUES (?, ?, ?)");
  for (const std::string& name : names) {
    const auto file = found_at(name);
    if (!file) continue;
    if (has_changed(database, *file) && is_used(database, *file, sweep)) {
      throw InputError(
          fmt::format("{}: {} has changed since runs of this store started from it; put the old "
                      "file back, or begin another store with -o",
                      database.name(), name));
    }
    keep.run(std::array<Cell, 3>{file->name, file->bytes, file->checksum});
  }
}

}  // namespace zenosphere
