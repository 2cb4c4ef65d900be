#pragma once

#include <gtest/gtest.h>

#include <string>

#include "../storage/temporary_folder.hpp"
#include "campaign/adjudication_columns.hpp"
#include "campaign/store.hpp"
#include "model/errors.hpp"
#include "sweep_texts.hpp"

namespace zenosphere {

/// A store in a folder that is gone afterwards, and what is in it.
class SweepStoreTest : public testing::Test {
 protected:
  std::string path() const { return (folder_.path / "s.sqlite").string(); }

  /// Takes over the store with a sweep, which may extend it.
  SweepStore store(const std::string& text = small_sweep) const {
    return {path(), parse_sweep(text, "s.toml")};
  }

  /// All rows: run, point, replica, the two axes, status.
  std::vector<std::string> rows() const {
    Database database(path(), Database::Access::read);
    Statement query = database.statement(
        "SELECT run, point, replica, \"system.restitution\", \"system.solids_volume_fraction\", "
        "status FROM run ORDER BY run");
    std::vector<std::string> rows;
    while (query.step()) {
      std::string row = cell_text(query.cell(0));
      for (int column = 1; column < 6; ++column) row += ' ' + cell_text(query.cell(column));
      rows.push_back(row);
    }
    return rows;
  }

  /// status|collisions|finding|groups left out|error
  std::string row_of(std::int64_t run) const {
    Database database(path(), Database::Access::read);
    return cell_text(database.value(
        "SELECT status || '|' || collisions || '|' || coalesce(adjudication_finding, '') || '|' || "
        "coalesce(adjudication_left_out, '') || '|' || coalesce(error, '') FROM run WHERE run = " +
        std::to_string(run)));
  }

  std::string cell(const std::string& column, int run) const {
    Database database(path(), Database::Access::read);
    return cell_text(
        database.value("SELECT " + column + " FROM run WHERE run = " + std::to_string(run)));
  }

  /// Takes from the store what its first format did not have.
  void make_first_format() const {
    Database database(path(), Database::Access::write);
    for (const AdjudicationColumn& column : adjudication_columns()) {
      database.execute("ALTER TABLE run DROP COLUMN " + std::string(column.name));
    }
    for (const char* name : {"groups", "seconds", "up_to", "collisions"}) {
      database.execute(std::string("ALTER TABLE sweep DROP COLUMN adjudicate_") + name);
    }
    database.execute("UPDATE sweep SET format_version = 1");
    database.execute("PRAGMA user_version = 1");
  }

  std::string refusal(const std::string& text) const {
    try {
      store(text);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "accepted";
  }

  TemporaryFolder folder_;
};

inline Summary some_summary() {
  Summary summary;
  summary.outcome = Outcome::finished;
  summary.verdict = Verdict::none;
  summary.collisions = 320;
  return summary;
}

inline const std::string judging_sweep = small_sweep + "[adjudicate]\ngroups = 1\n";

inline Summary with_hits() {
  Summary summary = some_summary();
  summary.separation.hits = 2;
  return summary;
}

inline AdjudicationResult some_findings() {
  Adjudication found;
  found.left_out = 7;
  found.finding = Finding::singular;
  return {.cells = adjudication_cells({found, 0.5})};
}

}  // namespace zenosphere
