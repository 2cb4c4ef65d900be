#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "case/case.hpp"
#include "case/case_entries.hpp"
#include "model/case_key.hpp"

namespace zenosphere::case_format {

/// The member of a Case that a key fills.
using Slot =
    std::variant<double*, int*, std::int64_t*, std::uint64_t*, bool*, std::optional<double>*,
                 std::optional<std::int64_t>*, Arrangement*, DriveKind*, OverlapRule*, Precision*,
                 GapThreshold*, AverageStart*, SnapshotSpacing*, RestitutionLaw*, CollisionLog*,
                 std::optional<Axis>*, std::optional<OscillationShape>*,
                 std::optional<SizeDistribution>*, std::optional<Friction>*, std::string*,
                 std::vector<double>*, std::vector<std::vector<double>>*>;

/// Most spheres whose positions a case file may write down: they make it 15 MB large.
inline constexpr std::size_t most_written_spheres = 100'000;

/// A key that exists only where others have certain values.
struct Condition {
  std::array<std::string_view, 2> depends_on;  ///< the other keys; the second may be empty
  bool (*holds)(const Case&);
  std::string_view text;  ///< `drive.kind = "shear"`
};

/// One key of the case file: one row of the table that everything else is made from.
struct Key : CaseKey {
  std::string_view table;
  std::optional<Condition> condition;  ///< none: the key always exists
  std::size_t number;                  ///< of all, from 0

  std::string path() const { return std::string(table) + '.' + std::string(name); }
  bool exists_in(const Case& values) const { return !condition || condition->holds(values); }
  /// The member that it fills.
  Slot slot(Case& values) const;
};

/// `must be in [0, 1]; 1 is elastic`
std::string range_text(const Range& range);

/// All keys, in the order of the reference page.
std::span<const Key> keys();

/// The key of that table and name, or null.
const Key* key_named(std::string_view table, std::string_view name);

bool is_table(std::string_view name);

/// The key that the user probably meant, or null: one of the same table with a near name, else
/// one of any table.
const Key* nearest_key(std::string_view table, std::string_view name);

/// The table that the user probably meant, or nothing.
std::optional<std::string_view> nearest_table(std::string_view name);

/// Stores a value of the user in its member.
///
/// Integers stand for real numbers, real numbers without a fraction for integers, and a number for
/// an array of one. How many numbers an array must have is not judged here.
///
/// \return  why not, and what to do, as in `(must be in [0, 1]; 1 is elastic)`; nothing if stored
std::optional<std::string> store(Slot slot, const Range& range, const Value& value);

/// A value as TOML writes it, or nothing if there is none.
std::optional<std::string> toml_text(Slot slot);

/// The value as TOML writes it, or nothing if the key has none in this case, which stays unchanged.
std::optional<std::string> toml_text(const Key& key, Case& values);

}  // namespace zenosphere::case_format
