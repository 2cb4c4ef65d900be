#include "report/sweep_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/run_case.hpp"
#include "campaign/store.hpp"
#include "case/case_file.hpp"
#include "text/json.hpp"

namespace zenosphere {
namespace {

/// Columns of the table `run` that the page shows; a store without adjudication has no others.
constexpr std::array<std::string_view, 17> columns{"run",
                                                   "point",
                                                   "replica",
                                                   "status",
                                                   "error",
                                                   "outcome",
                                                   "verdict",
                                                   "collisions",
                                                   "time",
                                                   "strain",
                                                   "arrest_met",
                                                   "separation_hits",
                                                   "separation_first_collision",
                                                   "arrest_collision",
                                                   "arrest_pairs",
                                                   "granular_temperature",
                                                   "collision_rate"};

/// Further ones, of what `adjudicate` found in each run.
constexpr std::array<std::string_view, 5> findings{"adjudication_first_finding",
                                                   "adjudication_finding", "adjudication_sentence",
                                                   "adjudication_groups", "adjudication_left_out"};

/// Those of both that the store has; all of the first, so that a damaged one is an error.
std::vector<std::string_view> columns_in(Database& store) {
  std::vector<std::string_view> found(columns.begin(), columns.end());
  Statement query = store.statement("SELECT name FROM pragma_table_info('run')");
  while (query.step()) {
    const std::string name = cell_text(query.cell(0));
    const auto column = std::ranges::find(findings, name);
    if (column != findings.end()) found.push_back(*column);
  }
  return found;
}

Json json_of(const Cell& cell) {
  if (const auto* integer = std::get_if<std::int64_t>(&cell)) return *integer;
  if (const auto* real = std::get_if<double>(&cell)) return *real;
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  return {};
}

/// `, "system.restitution"` and so on: the columns of the axes.
std::string axis_list(const StoredSweep& sweep) {
  std::vector<AxisKey> keys;
  for (const StoredAxis& axis : sweep.axes) keys.push_back(axis.key);
  return axis_columns(keys);
}

/// Searches have no seeds: each of their runs has a seed, and a place on the last axis, of its own.
bool is_search(const StoredSweep& sweep) { return sweep.seeds == 0; }

/// The table `run` with the number of the point of the page that each run belongs to, `place`. Of a
/// grid it is the point of the store, which in a search has runs all along the last axis.
std::string runs_with_places(const StoredSweep& sweep) {
  const std::string place =
      is_search(sweep) ? fmt::format("min(run) OVER (PARTITION BY point{})", axis_list(sweep))
                       : "point";
  return fmt::format("(SELECT *, {} AS place FROM run)", place);
}

/// The rows of the store, column by column. Seeds are text: they have more digits than a number of
/// JavaScript.
Json runs_of(Database& store, const StoredSweep& sweep) {
  std::string list;
  Json json = Json::object();
  const auto names = columns_in(store);
  for (const auto& name : names) {
    list += fmt::format("{}, ", name == "point" ? "place" : name);
    json[std::string(name)] = Json::array();
  }
  json["seed"] = Json::array();
  Statement query =
      store.statement("SELECT " + list + "seed FROM " + runs_with_places(sweep) + " ORDER BY run");
  while (query.step()) {
    for (std::size_t n = 0; n < names.size(); ++n) {
      json[std::string(names[n])].push_back(json_of(query.cell(static_cast<int>(n))));
    }
    json["seed"].push_back(cell_text(query.cell(static_cast<int>(names.size()))));
  }
  return json;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t begin = 0;
  for (std::size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
    lines.push_back(text.substr(begin, end - begin));
  }
  lines.push_back(text.substr(begin));
  return lines;
}

/// The lines of a case file that differ from those of the first: {"4": "restitution = 0.3"}; all of
/// it as an array where it has more or fewer of them.
Json difference(const std::vector<std::string>& first, const std::vector<std::string>& lines) {
  if (lines.size() != first.size()) return lines;
  Json changed = Json::object();
  for (std::size_t n = 0; n < lines.size(); ++n) {
    if (lines[n] != first[n]) changed[std::to_string(n)] = lines[n];
  }
  return changed;
}

/// The resolved case of one run of each point: the first one whole, the others as what differs.
Json cases_of(Database& store, const StoredSweep& sweep) {
  StoredRuns runs(store, sweep);
  Statement query = store.statement("SELECT place, min(run) FROM " + runs_with_places(sweep) +
                                    " GROUP BY place ORDER BY place");
  Json json{{"first", Json::array()}, {"points", Json::object()}};
  std::vector<std::string> first;
  while (query.step()) {
    const std::int64_t point = integer_in(query.cell(0), store.name());
    const RunTask task = runs.run(integer_in(query.cell(1), store.name()));
    const auto lines = lines_of(resolved_toml(case_of_run(sweep.base, sweep.stop, task.overrides)));
    if (first.empty()) json["first"] = first = lines;
    json["points"][std::to_string(point)] = difference(first, lines);
  }
  return json;
}

/// Where each point is on the axes: {"0": [0.1, "fcc"]}.
Json places_of(Database& store, const StoredSweep& sweep) {
  Statement query = store.statement("SELECT place, min(run)" + axis_list(sweep) + " FROM " +
                                    runs_with_places(sweep) + " GROUP BY place ORDER BY place");
  Json json = Json::object();
  while (query.step()) {
    Json place = Json::array();
    for (int n = 2; n < query.columns(); ++n) place.push_back(json_of(query.cell(n)));
    json[std::to_string(integer_in(query.cell(0), store.name()))] = place;
  }
  return json;
}

/// Every value on an axis that has a run, ascending.
Json tried_values(Database& store, const AxisKey& key) {
  Statement query =
      store.statement(fmt::format("SELECT DISTINCT \"{}\" FROM run ORDER BY 1", key.path()));
  Json values = Json::array();
  while (query.step()) values.push_back(json_of(query.cell(0)));
  return values;
}

Json axes_of(Database& store, const StoredSweep& sweep) {
  Json json = Json::array();
  for (const StoredAxis& axis : sweep.axes) {
    Json values = Json::array();
    for (const std::string& value : axis.values) values.push_back(Json::parse(value));
    json.push_back({{"key", axis.key.path()}, {"values", values}});
  }
  if (is_search(sweep)) json.back()["values"] = tried_values(store, sweep.axes.back().key);
  return json;
}

std::string sweep_json(const std::string& name, Database& store) {
  const StoredSweep sweep = stored_sweep(store);
  const Json json{{"kind", "sweep"},
                  {"name", name},
                  {"sweep_file", sweep.sweep_file},
                  {"master_seed", std::to_string(sweep.master_seed)},
                  {"seeds", sweep.seeds},
                  {"program_version", sweep.program_version},
                  {"git_hash", sweep.git_hash},
                  {"axes", axes_of(store, sweep)},
                  {"places", places_of(store, sweep)},
                  {"cases", cases_of(store, sweep)},
                  {"runs", runs_of(store, sweep)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

void write_sweep_page(const std::filesystem::path& store, const std::filesystem::path& page,
                      Existing existing) {
  Database database(store, Database::Access::read);
  const std::string json = sweep_json(store.filename().string(), database);
  PageWriter writer(page, existing);
  writer.add_json("sweep", json);
  writer.finish();
}

}  // namespace zenosphere
