#pragma once

#include <limits>
#include <string_view>

namespace zenosphere::case_format {

/// The numbers that a key of a case takes: from `low` to `high`, `low` itself only if
/// `low_belongs`.
struct Range {
  double low;
  double high;
  bool low_belongs;
  std::string_view note;  ///< what the message adds, for example `1 is elastic`

  bool contains(double number) const {
    return number <= high && (low_belongs ? number >= low : number > low);
  }
};

inline constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr Range at_least(double low) { return {low, infinite, true, ""}; }
constexpr Range above(double low) { return {low, infinite, false, ""}; }
constexpr Range from_to(double low, double high, std::string_view note = "") {
  return {low, high, true, note};
}
constexpr Range above_to(double low, double high, std::string_view note = "") {
  return {low, high, false, note};
}
inline constexpr Range any = from_to(-infinite, infinite);

enum class Presence {
  required,
  optional,
  with_table,  ///< required where the table is there, even if it is empty
};
inline constexpr auto required = Presence::required;
inline constexpr auto optional = Presence::optional;
inline constexpr auto with_table = Presence::with_table;

/// What a key of the case file is called, whether it must be there, what it takes and means.
///
/// A table of the case lists its keys once, each beside the member that it fills, in `keys(visit)`,
/// which calls `visit(CaseKey, member)`, or `visit(CaseKey, member, When)` for a key that is not
/// always there. From that list come reading, writing, `check`, the test of the reference page,
/// and the axes of sweeps.
struct CaseKey {
  std::string_view name;
  Presence presence;
  Range range;               ///< of every number; words and booleans ignore it
  std::string_view meaning;  ///< with the unit in brackets; a comment in resolved files
};

/// When a key exists: where others have certain values.
template <class Holds>
struct When {
  std::string_view depends_on;  ///< `drive.kind`
  std::string_view and_on;      ///< another one, or empty
  /// Of a whole case: a generic lambda, for Case is not complete where its tables are.
  Holds holds;
  std::string_view text;  ///< `drive.kind = "shear"`
};
template <class Holds>
When(const char*, const char*, Holds, std::string_view) -> When<Holds>;

}  // namespace zenosphere::case_format
