#include "campaign/run_columns.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "campaign/average_columns.hpp"
#include "storage/build_info.hpp"

namespace zenosphere {
namespace {

Cell arrest_pairs(const Summary& summary) {
  std::string text;
  for (const auto& [i, j] : summary.arrest.pairs) {
    text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", i, j);
  }
  return '[' + text + ']';
}

std::vector<ResultColumn> columns_of_collapse() {
  return {
      {"outcome", "TEXT", [](const Summary& s) -> Cell { return word(s.outcome); }},
      {"ended_by", "TEXT", [](const Summary& s) -> Cell { return word(s.ended_by); }},
      {"verdict", "TEXT", [](const Summary& s) -> Cell { return word(s.verdict); }},
      {"collisions", "INTEGER", [](const Summary& s) -> Cell { return s.collisions; }},
      {"collisions_per_sphere", "REAL",
       [](const Summary& s) -> Cell { return s.collisions_per_sphere; }},
      {"time", "REAL", [](const Summary& s) -> Cell { return s.time; }},
      {"strain", "REAL", [](const Summary& s) -> Cell { return s.strain; }},
      {"separation_hits", "INTEGER", [](const Summary& s) -> Cell { return s.separation.hits; }},
      {"separation_first_collision", "INTEGER",
       [](const Summary& s) { return or_null(s.separation.first_collision); }},
      {"separation_first_time", "REAL",
       [](const Summary& s) { return or_null(s.separation.first_time); }},
      {"separation_last_collision", "INTEGER",
       [](const Summary& s) { return or_null(s.separation.last_collision); }},
      {"arrest_met", "INTEGER",
       [](const Summary& s) -> Cell { return std::int64_t{s.arrest.met ? 1 : 0}; }},
      {"arrest_collision", "INTEGER", [](const Summary& s) { return or_null(s.arrest.collision); }},
      {"arrest_time", "REAL", [](const Summary& s) { return or_null(s.arrest.time); }},
      {"arrest_window", "INTEGER", [](const Summary& s) -> Cell { return s.arrest.window; }},
      {"arrest_pairs", "TEXT", arrest_pairs},
      {"absorbed", "INTEGER", [](const Summary& s) -> Cell { return s.absorbed; }},
  };
}

std::vector<ResultColumn> columns_of_program() {
  return {
      {"ledger_error", "REAL", [](const Summary& s) -> Cell { return s.ledger_error; }},
      {"wall_seconds", "REAL", [](const Summary& s) -> Cell { return s.wall_seconds; }},
      {"program_version", "TEXT",
       [](const Summary&) -> Cell { return std::string(build_info::program_version); }},
      {"git_hash", "TEXT",
       [](const Summary&) -> Cell { return std::string(build_info::git_hash); }},
  };
}

std::vector<ResultColumn> all_columns() {
  std::vector<ResultColumn> columns = columns_of_collapse();
  for (auto&& more : {average_columns(), columns_of_program()}) {
    columns.insert(columns.end(), more.begin(), more.end());
  }
  return columns;
}

}  // namespace

std::span<const ResultColumn> result_columns() {
  static const std::vector<ResultColumn> columns = all_columns();
  return columns;
}

}  // namespace zenosphere
