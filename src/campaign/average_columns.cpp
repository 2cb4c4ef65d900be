#include "campaign/average_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/column_cell.hpp"

namespace zenosphere {
namespace {

/// JSON has no number that is not finite.
std::string json_number(double number) {
  return std::isfinite(number) ? fmt::format("{}", number) : "null";
}

/// `[1, 2]`, the numbers from `begin` on.
std::string json_row(const std::vector<double>& numbers, std::size_t begin, std::size_t count) {
  std::string text;
  for (std::size_t n = begin; n < begin + count; ++n) {
    text += (n == begin ? "" : ", ") + json_number(numbers[n]);
  }
  return '[' + text + ']';
}

/// `[[1, 2], [3, 4]]`, of a square matrix.
std::string json_matrix(const std::vector<double>& numbers) {
  const double size = std::round(std::sqrt(static_cast<double>(numbers.size())));
  const auto count = static_cast<std::size_t>(size);
  std::string text;
  for (std::size_t row = 0; row < count; ++row) {
    text += (row == 0 ? "" : ", ") + json_row(numbers, row * count, count);
  }
  return '[' + text + ']';
}

Cell cell_of(double number, Shape) { return number; }
Cell cell_of(const std::optional<double>& number, Shape) { return or_null(number); }
Cell cell_of(const std::vector<double>& numbers, Shape shape) {
  if (numbers.empty()) return {};
  return shape == Shape::matrix ? json_matrix(numbers) : json_row(numbers, 0, numbers.size());
}

/// A cell of each observable in their order; all are empty where there are no observables.
std::vector<Cell> cells_of(const Observables* observables) {
  std::vector<Cell> cells;
  const Observables none;
  Observables::fields(observables ? *observables : none,
                      [&](const char*, const auto& member, Shape shape, Mean) {
                        cells.push_back(observables ? cell_of(member, shape) : Cell());
                      });
  return cells;
}

}  // namespace

void add_average_columns(const std::optional<Averages>& averages,
                         std::vector<ResultColumn>& columns) {
  const Averages none;
  const Averages& a = averages ? *averages : none;
  const auto values = cells_of(averages ? &a : nullptr);
  const auto errors = cells_of(a.standard_error ? &*a.standard_error : nullptr);
  std::size_t n = 0;
  Observables::fields(a, [&](const std::string& name, const auto&, Shape shape, Mean) {
    const std::string_view type = shape == Shape::number ? "REAL" : "TEXT";
    columns.push_back({name, type, values[n]});
    columns.push_back({name + "_standard_error", type, errors[n++]});
  });
  std::vector<ResultColumn> remarks;
  Averages::remarks(a, [&](const Field& field, const auto& member) {
    remarks.push_back(column_of(field, member));
    if (!averages) remarks.back().cell = {};
  });
  // In every format of the store those of the flow come first.
  std::ranges::stable_partition(
      remarks, [](const ResultColumn& column) { return !column.name.starts_with("averages_"); });
  columns.insert(columns.end(), remarks.begin(), remarks.end());
}

}  // namespace zenosphere
