#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/axis_key.hpp"
#include "case/case_entries.hpp"
#include "case/case_problems.hpp"

namespace zenosphere {

/// One value of an axis, in the type of its key, and where it was written.
struct AxisValue {
  case_format::Value value;
  case_format::Place place;
};

/// A key that a sweep varies.
struct SweepAxis {
  AxisKey key;
  std::vector<AxisValue> values;  ///< in the order of the sweep file, no two the same

  std::string path() const { return key.path(); }
  std::size_t size() const { return values.size(); }
};

/// A range of numbers, `from` and `to` included.
struct AxisRange {
  double from = 0;
  double to = 0;
  std::int64_t points = 0;  ///< at least 2
  enum class Spacing { linear, log } spacing = Spacing::linear;
};

/// The numbers of a range, rounded to twelve digits: 0.3 rather than 0.30000000000000004, and the
/// same whatever the C library's exponential; whole numbers where the key holds a count.
std::vector<case_format::Value> numbers_of(const AxisRange& range, Storage storage);

/// The value in the type that the key stores: 1 becomes 1.0 for a real number, 1e3 becomes 1000 for
/// a count. What does not fit stays as it is; the case reader tells why.
case_format::Value in_storage(case_format::Value value, Storage storage);

/// The value as it stands in the store's column, in CSV and in an override.
std::string column_text(const case_format::Value& value);

}  // namespace zenosphere
