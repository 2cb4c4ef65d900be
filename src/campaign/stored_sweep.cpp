#include "campaign/stored_sweep.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <map>
#include <nlohmann/json.hpp>

#include "campaign/adjudication_columns.hpp"
#include "campaign/run_columns.hpp"
#include "campaign/stored_adjudication.hpp"
#include "storage/build_info.hpp"

namespace zenosphere {

std::string_view sqlite_type(Storage storage) {
  switch (storage) {
    case Storage::integer:
      return "INTEGER";
    case Storage::real:
      return "REAL";
    case Storage::text:
      break;
  }
  return "TEXT";
}

namespace {

std::string run_table(const std::vector<SweepAxis>& axes) {
  std::string sql =
      "CREATE TABLE run (run INTEGER PRIMARY KEY, point INTEGER NOT NULL, replica INTEGER NOT "
      "NULL, seed INTEGER NOT NULL";
  for (const SweepAxis& axis : axes) {
    sql += fmt::format(", \"{}\" {} NOT NULL", axis.path(), sqlite_type(axis.key.storage()));
  }
  sql += ", status TEXT NOT NULL, error TEXT";
  for (const ResultColumn& column : result_columns()) {
    sql += fmt::format(", {} {}", column.name, column.type);
  }
  for (const AdjudicationColumn& column : adjudication_columns()) {
    sql += fmt::format(", {} {}", column.name, column.type);
  }
  return sql + ')';
}

std::optional<double> real_or_nothing(const Cell& cell) {
  const auto* number = std::get_if<double>(&cell);
  return number ? std::optional(*number) : std::nullopt;
}

/// `[0.1, 0.2]`: the values of an axis in one JSON array.
std::string json_array(const SweepAxis& axis) {
  std::string text;
  for (const std::string& value : json_values(axis)) text += (text.empty() ? "" : ", ") + value;
  return '[' + text + ']';
}

void write_axes(Database& database, const Sweep& sweep) {
  database.execute("DELETE FROM axis");
  Statement insert =
      database.statement("INSERT INTO axis (position, key, \"values\") VALUES (?, ?, ?)");
  for (std::size_t n = 0; n < sweep.axes.size(); ++n) {
    const SweepAxis& axis = sweep.axes[n];
    insert.run(std::array<Cell, 3>{static_cast<std::int64_t>(n), axis.path(), json_array(axis)});
  }
}

[[noreturn]] void reject_damaged(const std::string& name, const std::string& what) {
  throw OutputError(
      fmt::format("{}: is damaged ({}); restore a copy of it, or begin another store "
                  "with -o",
                  name, what));
}

/// One of the values of an axis in the form in which two of them are compared.
std::vector<std::string> values_in(const std::string& json, const std::string& name) {
  const auto array = nlohmann::json::parse(json, nullptr, false);
  if (!array.is_array()) reject_damaged(name, "an axis without values");
  std::vector<std::string> values;
  for (const auto& value : array) values.push_back(value.dump());
  return values;
}

std::vector<StoredAxis> stored_axes(Database& database) {
  std::vector<StoredAxis> axes;
  Statement query = database.statement("SELECT key, \"values\" FROM axis ORDER BY position");
  while (query.step()) {
    const std::string path = text_in(query.cell(0), database.name());
    const auto key = AxisKey::named(path);
    if (!key) reject_damaged(database.name(), "an axis that is no key of a case");
    axes.push_back({*key, values_in(text_in(query.cell(1), database.name()), database.name())});
  }
  return axes;
}

/// Every key of a case with its value as TOML.
std::map<std::string, std::string> texts_of(const CaseTemplate& base) {
  std::map<std::string, std::string> texts;
  for (const case_format::Entry& entry : base.entries()) {
    texts[entry.key()] = std::holds_alternative<case_format::TableHead>(entry.value)
                             ? ""
                             : case_format::full_text(entry.value);
  }
  return texts;
}

std::string shortened(const std::string& text) {
  return text.size() > 60 ? text.substr(0, 60) + "..." : text;
}

/// Lines for what two lists of named values do not share.
void compare(const std::map<std::string, std::string>& before,
             const std::map<std::string, std::string>& now, std::vector<std::string>& lines) {
  std::map<std::string, std::string> all = before;
  all.insert(now.begin(), now.end());
  for (const auto& [name, unused] : all) {
    const auto old = before.find(name);
    const auto fresh = now.find(name);
    const std::string was = old == before.end() ? "absent" : shortened(old->second);
    const std::string is = fresh == now.end() ? "absent" : shortened(fresh->second);
    if (was != is) lines.push_back(fmt::format("{} is {} ({} in the store)", name, is, was));
  }
}

template <class Number>
std::string text_or_absent(const std::optional<Number>& number) {
  return number ? fmt::format("{}", *number) : "absent";
}

std::map<std::string, std::string> settings(std::int64_t master_seed, const StopRule& stop) {
  return {{"sweep.master_seed", fmt::format("{}", master_seed)},
          {"stop.collisions_per_sphere", text_or_absent(stop.collisions_per_sphere)},
          {"stop.wall_seconds", text_or_absent(stop.wall_seconds)}};
}

template <class Axes, class Path>
std::string list_of(const Axes& axes, Path path) {
  std::string text;
  for (const auto& axis : axes) text += (text.empty() ? "" : ", ") + path(axis);
  return text.empty() ? "none" : text;
}

/// Each as in `system.spheres is 4000 (500 in the store)`.
std::vector<std::string> differences(const StoredSweep& stored, const Sweep& sweep) {
  std::vector<std::string> lines;
  compare(settings(stored.master_seed, stored.stop), settings(sweep.master_seed, sweep.stop),
          lines);
  if (stored.has_findings) {
    compare(settings(stored.adjudicate), settings(sweep.adjudicate), lines);
  }
  const std::string before =
      list_of(stored.axes, [](const StoredAxis& axis) { return axis.key.path(); });
  const std::string now = list_of(sweep.axes, [](const SweepAxis& axis) { return axis.path(); });
  if (before != now) {
    lines.push_back(fmt::format("the axes are {} ({} in the store)", now, before));
    return lines;  // what else differs, differs because of that
  }
  const CaseTemplate base(case_format::entries_of(sweep.base_text, sweep.name), sweep.name);
  compare(texts_of(stored.base), texts_of(base), lines);
  if (sweep.seeds < stored.seeds) {
    lines.push_back(fmt::format("sweep.seeds is {} ({} in the store)", sweep.seeds, stored.seeds));
  }
  for (std::size_t n = 0; n < sweep.axes.size(); ++n) {
    const auto values = json_values(sweep.axes[n]);
    if (sweep.boundary && values != stored.axes[n].values) {
      lines.push_back(
          fmt::format("axes.\"{}\" has other values or another order (the points of a "
                      "search keep theirs)",
                      sweep.axes[n].path()));
      continue;
    }
    for (const std::string& value : stored.axes[n].values) {
      if (std::find(values.begin(), values.end(), value) != values.end()) continue;
      lines.push_back(fmt::format("axes.\"{}\" lacks {} (which the store has)",
                                  sweep.axes[n].path(), shortened(value)));
    }
  }
  return lines;
}

}  // namespace

std::vector<std::string> json_values(const SweepAxis& axis) {
  std::vector<std::string> values;
  for (const AxisValue& value : axis.values) {
    values.push_back(nlohmann::json::parse(case_format::full_text(value.value)).dump());
  }
  return values;
}

std::string axis_columns(const std::vector<AxisKey>& keys) {
  std::string text;
  for (const AxisKey& key : keys) text += fmt::format(", \"{}\"", key.path());
  return text;
}

void create_tables(Database& database, const Sweep& sweep) {
  database.execute(fmt::format("PRAGMA application_id = {}", store_application_id));
  database.execute(fmt::format("PRAGMA user_version = {}", store_format_version));
  database.execute(
      "CREATE TABLE sweep (format_version INTEGER NOT NULL, sweep_file TEXT NOT NULL, base_case "
      "TEXT NOT NULL, master_seed INTEGER NOT NULL, seeds INTEGER NOT NULL, "
      "stop_collisions_per_sphere REAL, stop_wall_seconds REAL, program_version TEXT NOT NULL, "
      "git_hash TEXT NOT NULL, created TEXT NOT NULL)");
  add_request_columns(database);
  database.execute(
      "CREATE TABLE axis (position INTEGER PRIMARY KEY, key TEXT NOT NULL UNIQUE, \"values\" TEXT "
      "NOT NULL)");
  database.execute(run_table(sweep.axes));
  const std::string now = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  database
      .statement(
          "INSERT INTO sweep (format_version, sweep_file, base_case, master_seed, seeds, "
          "stop_collisions_per_sphere, stop_wall_seconds, program_version, git_hash, created) "
          "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .run(std::array<Cell, 10>{
          store_format_version, sweep.text, sweep.base_text, sweep.master_seed, sweep.seeds,
          or_null(sweep.stop.collisions_per_sphere), or_null(sweep.stop.wall_seconds),
          std::string(build_info::program_version), std::string(build_info::git_hash), now});
  write_request(database, sweep.adjudicate);
  write_axes(database, sweep);
}

void update_sweep(Database& database, const Sweep& sweep) {
  database.statement("UPDATE sweep SET sweep_file = ?, seeds = ?")
      .run(std::array<Cell, 2>{sweep.text, sweep.seeds});
  write_request(database, sweep.adjudicate);
  write_axes(database, sweep);
}

bool is_empty(Database& database) {
  return database.integer("SELECT count(*) FROM sqlite_master") == 0;
}

StoredSweep stored_sweep(Database& database) {
  const std::string& name = database.name();
  if (database.integer("PRAGMA application_id") != store_application_id) {
    throw InputError(name + ": is a database of another program; choose another file");
  }
  const std::int64_t version = database.integer("PRAGMA user_version");
  if (version < oldest_store_version || version > store_format_version) {
    throw OutputError(
        fmt::format("{}: is a store of format {} (this program reads {} to {}); use the "
                    "program that wrote it",
                    name, version, oldest_store_version, store_format_version));
  }
  Statement query = database.statement(
      "SELECT sweep_file, base_case, master_seed, seeds, stop_collisions_per_sphere, "
      "stop_wall_seconds, program_version, git_hash FROM sweep");
  if (!query.step()) reject_damaged(name, "it does not say of which sweep it is");
  StoredSweep sweep{.sweep_file = text_in(query.cell(0), name),
                    .base = {case_format::entries_of(text_in(query.cell(1), name), name), name},
                    .axes = stored_axes(database),
                    .seeds = integer_in(query.cell(3), name),
                    .master_seed = integer_in(query.cell(2), name),
                    .stop = {real_or_nothing(query.cell(4)), real_or_nothing(query.cell(5))},
                    .format_version = version,
                    .program_version = text_in(query.cell(6), name),
                    .git_hash = text_in(query.cell(7), name)};
  read_request(database, sweep);
  return sweep;
}

void require_same(const StoredSweep& stored, const Sweep& sweep, const std::string& name) {
  std::string list;
  for (const std::string& line : differences(stored, sweep)) list += "\n  " + line;
  if (list.empty()) return;
  throw InputError(
      fmt::format("{}: holds the runs of another sweep than {} (what differs is "
                  "below); choose another store with -o{}",
                  name, sweep.name, list));
}

}  // namespace zenosphere
