#pragma once

#include <span>
#include <string_view>

#include "campaign/database.hpp"
#include "result/summary.hpp"

namespace zenosphere {

/// A column of the table `run` that holds a part of what a run came to.
struct ResultColumn {
  std::string_view name;
  std::string_view type;  ///< of SQLite
  Cell (*cell)(const Summary&);
};

/// All of them, in the order of the table; docs/sweep-file.md tells their units.
std::span<const ResultColumn> result_columns();

}  // namespace zenosphere
