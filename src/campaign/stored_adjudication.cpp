#include "campaign/stored_adjudication.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "campaign/adjudication_columns.hpp"
#include "campaign/run_columns.hpp"
#include "model/errors.hpp"

namespace zenosphere {

namespace {

constexpr std::int64_t first_with_adjudication = 2;  ///< store format

constexpr std::array<std::string_view, 4> request_columns{
    "adjudicate_groups INTEGER", "adjudicate_seconds REAL", "adjudicate_up_to TEXT",
    "adjudicate_collisions INTEGER"};

/// As a value of `[adjudicate]` that may be missing.
std::string text_or_absent(const std::optional<std::int64_t>& number) {
  return number ? fmt::format("{}", *number) : "absent";
}

/// Adds a column to the table of runs, unless it is there.
void add_column(Database& database, std::string_view name, std::string_view type) {
  const auto known = database.integer(
      fmt::format("SELECT COUNT(*) FROM pragma_table_info('run') WHERE name = '{}'", name));
  if (known == 0) database.execute(fmt::format("ALTER TABLE run ADD COLUMN {} {}", name, type));
}

}  // namespace

void add_request_columns(Database& database) {
  for (const std::string_view column : request_columns) {
    database.execute(fmt::format("ALTER TABLE sweep ADD COLUMN {}", column));
  }
}

void write_request(Database& database, const std::optional<AdjudicationRequest>& request) {
  std::array<Cell, 4> cells{};
  if (request) {
    cells = {or_null(request->groups), request->seconds, Cell(), or_null(request->collisions)};
    if (request->up_to) cells[2] = request->up_to->word();
  }
  database
      .statement(
          "UPDATE sweep SET adjudicate_groups = ?, adjudicate_seconds = ?, adjudicate_up_to = ?, "
          "adjudicate_collisions = ?")
      .run(cells);
}

void read_request(Database& database, StoredSweep& sweep) {
  if (sweep.format_version < first_with_adjudication) return;
  Statement query = database.statement(
      "SELECT adjudicate_groups, adjudicate_seconds, adjudicate_up_to, adjudicate_collisions, "
      "EXISTS (SELECT 1 FROM run WHERE adjudication_finding IS NOT NULL) FROM sweep");
  query.step();
  const auto count = [&](int column) {
    const Cell cell = query.cell(column);
    const auto* number = std::get_if<std::int64_t>(&cell);
    return number ? std::optional(*number) : std::nullopt;
  };
  sweep.has_findings = count(4) == 1;
  const Cell told = query.cell(1);
  const auto* seconds = std::get_if<double>(&told);
  if (!seconds) return;
  sweep.adjudicate = {.groups = count(0), .seconds = *seconds, .up_to = {}, .collisions = count(3)};
  const std::string up_to = cell_text(query.cell(2));
  if (up_to.empty()) return;
  sweep.adjudicate->up_to = Precision::from_word(up_to);
  if (!sweep.adjudicate->up_to) {
    throw OutputError(fmt::format(
        "{}: is damaged (adjudicate_up_to = {}); restore a copy of it, or begin another "
        "store with -o",
        database.name(), up_to));
  }
}

std::map<std::string, std::string> settings(const std::optional<AdjudicationRequest>& request) {
  if (!request) return {{"[adjudicate]", "absent"}};
  return {{"[adjudicate]", "there"},
          {"adjudicate.groups", text_or_absent(request->groups)},
          {"adjudicate.seconds", fmt::format("{}", request->seconds)},
          {"adjudicate.up_to", request->up_to ? request->up_to->word() : "absent"},
          {"adjudicate.collisions", text_or_absent(request->collisions)}};
}

void upgrade(Database& database, const StoredSweep& stored) {
  if (stored.format_version >= store_format_version) return;
  if (stored.format_version < first_with_adjudication) add_request_columns(database);
  for (const ResultColumn& column : result_columns()) {
    add_column(database, column.name, column.type);
  }
  for (const AdjudicationColumn& column : adjudication_columns()) {
    add_column(database, column.name, column.type);
  }
  database.execute(fmt::format("UPDATE sweep SET format_version = {}", store_format_version));
  database.execute(fmt::format("PRAGMA user_version = {}", store_format_version));
}

std::string waits_for_adjudication(const StoredSweep& sweep) {
  if (!sweep.adjudicate) return "0";
  const std::string hits = "status = 'done' AND separation_hits > 0 AND error IS NULL";
  if (sweep.format_version < first_with_adjudication) return '(' + hits + ')';
  return '(' + hits + " AND adjudication_finding IS NULL)";
}

}  // namespace zenosphere
