#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "case/case_problems.hpp"
#include "case/case_table.hpp"
#include "case/case_tree.hpp"

namespace zenosphere {

/// A key of a table of the sweep file and what takes its value.
struct SweepField {
  std::string_view name;
  /// Why the value is wrong, as in `(must be > 0)`; nothing if it was taken.
  std::function<std::optional<std::string>(const case_format::Value&)> take;
};

/// Takes a whole number in a range into `slot`.
SweepField count_field(std::string_view name, std::int64_t& slot, case_format::Range range);
/// Takes a number in a range.
SweepField number_field(std::string_view name, std::optional<double>& slot,
                        case_format::Range range);
/// Takes a text that is not empty and not longer than a thousand bytes.
SweepField text_field(std::string_view name, std::optional<std::string>& slot);

/// Reads the keys of a table; unknown and wrong ones become problems.
///
/// \param prefix  what messages put in front of a key, for example `sweep.`
void read_fields(const case_format::TreeNode& table, const std::string& prefix,
                 std::span<const SweepField> fields, case_format::Problems& problems);

/// Longest text that a sweep file may give as a value [bytes].
inline constexpr std::size_t longest_text = 1000;

}  // namespace zenosphere
