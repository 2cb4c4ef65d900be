#include "campaign/axis.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <utility>
#include <variant>

namespace zenosphere {

using case_format::Value;

std::vector<Value> numbers_of(const AxisRange& range, Storage storage) {
  std::vector<Value> numbers;
  for (std::int64_t point = 0; point < range.points; ++point) {
    const double part = static_cast<double>(point) / static_cast<double>(range.points - 1);
    double number = range.spacing == AxisRange::Spacing::linear
                        ? range.from + (range.to - range.from) * part
                        : range.from * std::pow(range.to / range.from, part);
    if (point == 0) number = range.from;
    if (point + 1 == range.points) number = range.to;
    number = std::strtod(fmt::format("{:.12g}", number).c_str(), nullptr);
    if (storage == Storage::integer) number = std::round(number);
    numbers.push_back(in_storage(number, storage));
  }
  return numbers;
}

Value in_storage(Value value, Storage storage) {
  const auto* integer = std::get_if<std::int64_t>(&value);
  const auto* real = std::get_if<double>(&value);
  if (storage == Storage::real && integer) return static_cast<double>(*integer);
  constexpr double exact = 0x1p53;
  const bool is_whole = real && *real == std::trunc(*real) && std::abs(*real) <= exact;
  if (storage == Storage::integer && is_whole) return static_cast<std::int64_t>(*real);
  return value;
}

std::string column_text(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return case_format::full_text(value);
}

}  // namespace zenosphere
