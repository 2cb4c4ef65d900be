#include "campaign/run_columns.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "storage/build_info.hpp"

namespace zenosphere {
namespace {

template <auto member>
Cell average(const Summary& summary) {
  return summary.averages ? Cell((*summary.averages).*member) : Cell();
}

/// JSON has no number that is not finite.
std::string json_number(double number) {
  return std::isfinite(number) ? fmt::format("{}", number) : "null";
}

/// `[1, 2]`, the numbers from `begin` on.
std::string json_row(const std::vector<double>& numbers, std::size_t begin, std::size_t count) {
  std::string text;
  for (std::size_t n = begin; n < begin + count; ++n) {
    text += (n == begin ? "" : ", ") + json_number(numbers[n]);
  }
  return '[' + text + ']';
}

Cell temperature_diagonal(const Summary& summary) {
  if (!summary.averages) return {};
  const auto& diagonal = summary.averages->temperature_diagonal;
  return json_row(diagonal, 0, diagonal.size());
}

Cell pressure_tensor(const Summary& summary) {
  if (!summary.averages) return {};
  const auto& tensor = summary.averages->pressure_tensor;
  const std::size_t dimension = summary.averages->temperature_diagonal.size();
  std::string text;
  for (std::size_t row = 0; row < dimension; ++row) {
    text += (row == 0 ? "" : ", ") + json_row(tensor, row * dimension, dimension);
  }
  return '[' + text + ']';
}

Cell arrest_pairs(const Summary& summary) {
  std::string text;
  for (const auto& [i, j] : summary.arrest.pairs) {
    text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", i, j);
  }
  return '[' + text + ']';
}

constexpr std::array<ResultColumn, 30> columns{{
    {"outcome", "TEXT", [](const Summary& s) -> Cell { return s.outcome; }},
    {"ended_by", "TEXT", [](const Summary& s) -> Cell { return s.ended_by; }},
    {"verdict", "TEXT", [](const Summary& s) -> Cell { return s.verdict; }},
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
    {"granular_temperature", "REAL", average<&Averages::granular_temperature>},
    {"pressure", "REAL", average<&Averages::pressure>},
    {"collision_rate", "REAL", average<&Averages::collision_rate>},
    {"dissipation", "REAL", average<&Averages::dissipation>},
    {"compressibility_factor", "REAL", average<&Averages::compressibility_factor>},
    {"temperature_diagonal", "TEXT", temperature_diagonal},
    {"pressure_tensor", "TEXT", pressure_tensor},
    {"averages_from_time", "REAL", average<&Averages::from_time>},
    {"averages_to_time", "REAL", average<&Averages::to_time>},
    {"ledger_error", "REAL", [](const Summary& s) -> Cell { return s.ledger_error; }},
    {"wall_seconds", "REAL", [](const Summary& s) -> Cell { return s.wall_seconds; }},
    {"program_version", "TEXT",
     [](const Summary&) -> Cell { return std::string(build_info::program_version); }},
    {"git_hash", "TEXT", [](const Summary&) -> Cell { return std::string(build_info::git_hash); }},
}};

}  // namespace

std::span<const ResultColumn> result_columns() { return columns; }

}  // namespace zenosphere
