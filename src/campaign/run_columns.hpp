#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/database.hpp"
#include "result/summary.hpp"

namespace zenosphere {

/// A column of the table `run` that holds a part of what a run came to.
struct ResultColumn {
  std::string name;
  std::string_view type;  ///< of SQLite
  Cell cell{};            ///< of one run
};

/// All of them, with what a run came to, in the order of the table: the fields of the summary that
/// have a column, and which program has made them. docs/sweep-file.md tells their units.
std::vector<ResultColumn> result_columns(const Summary& summary);

/// The same without a run.
std::span<const ResultColumn> result_columns();

/// A word of the column `ended_by` in a text of SQL: `'wall time'`.
inline std::string sql_word(EndedBy ended_by) { return '\'' + std::string(word(ended_by)) + '\''; }

}  // namespace zenosphere
