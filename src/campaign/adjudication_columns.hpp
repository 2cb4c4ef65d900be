#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "campaign/database.hpp"
#include "result/adjudication.hpp"

namespace zenosphere {

/// An adjudication with the time that it took.
struct TimedAdjudication {
  Adjudication found;
  double seconds = 0;  ///< wall time
};

/// A column of the table `run` that holds a part of what an adjudication found.
struct AdjudicationColumn {
  std::string_view name;
  std::string_view type;  ///< of SQLite
  Cell (*cell)(const TimedAdjudication&);
};

/// All of them, in the order of the table; docs/sweep-file.md tells what they mean.
std::span<const AdjudicationColumn> adjudication_columns();

/// The values of an adjudication in all of them.
std::vector<Cell> adjudication_cells(const TimedAdjudication& adjudication);

}  // namespace zenosphere
