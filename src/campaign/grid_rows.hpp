#pragma once

#include "campaign/database.hpp"
#include "campaign/stored_sweep.hpp"
#include "campaign/sweep.hpp"

namespace zenosphere {

/// A value as the column of its axis holds it.
Cell column_cell(const case_format::Value& value);

/// Adds a row for every run of a sweep that the store does not have yet, to be run.
///
/// The order is: replica outermost, then the axes with the last one fastest. What a sweep that has
/// been extended adds comes behind all rows there are, in the same order, and keeps its numbers.
///
/// \param before  what the store holds, all of its grid; null: nothing
void add_rows(Database& database, const Sweep& sweep, const StoredSweep* before);

}  // namespace zenosphere
