#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/database.hpp"
#include "campaign/sweep.hpp"

namespace zenosphere {

/// The format of a store, and the marks by which SQLite tells files of different programs.
inline constexpr std::int64_t store_format_version = 4;
inline constexpr std::int64_t oldest_store_version = 1;           ///< without adjudications
inline constexpr std::int64_t store_application_id = 0x5A454E4F;  // "ZENO"

/// An axis as a store has it.
struct StoredAxis {
  AxisKey key;
  std::vector<std::string> values;  ///< as JSON, `0.2` or `"rewind"`
};

/// What a store says about its sweep.
struct StoredSweep {
  std::string sweep_file;  ///< the text of it that the store was extended to last
  CaseTemplate base;
  std::vector<StoredAxis> axes;
  std::int64_t seeds = 0;
  std::int64_t master_seed = 0;
  StopRule stop;
  std::optional<AdjudicationRequest> adjudicate{};
  bool has_findings = false;  ///< some run has been adjudicated
  std::int64_t format_version = store_format_version;
  std::string program_version;  ///< of the program that began it
  std::string git_hash;
};

/// The type of a column.
std::string_view sqlite_type(Storage storage);

/// Creates the tables of a store for a sweep, without runs.
void create_tables(Database& database, const Sweep& sweep);

/// Makes a store tell the sweep that it has been extended to.
void update_sweep(Database& database, const Sweep& sweep);

/// Whether nothing at all is in the file yet.
bool is_empty(Database& database);

/// What a store says. Throws OutputError where the file is another program's, damaged, or of a
/// newer format.
StoredSweep stored_sweep(Database& database);

/// The values of an axis as JSON, in its order.
std::vector<std::string> json_values(const SweepAxis& axis);

/// Throws an InputError that tells what of a sweep is other than in the store `name`, if anything
/// is but what extends it: more seeds, more values on an axis, an adjudication.
void require_same(const StoredSweep& stored, const Sweep& sweep, const std::string& name);

/// The names of the axis columns, quoted, each with a comma and a space before it.
std::string axis_columns(const std::vector<AxisKey>& keys);

}  // namespace zenosphere
