#pragma once

#include <functional>
#include <span>
#include <string>

#include "campaign/database.hpp"
#include "result/summary.hpp"

namespace zenosphere {

/// A column of the table `run` that holds a part of what a run came to.
struct ResultColumn {
  std::string name;
  std::string type;  ///< of SQLite
  std::function<Cell(const Summary&)> cell;
};

/// All of them, in the order of the table; docs/sweep-file.md tells their units.
std::span<const ResultColumn> result_columns();

}  // namespace zenosphere
