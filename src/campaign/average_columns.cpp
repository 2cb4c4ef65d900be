#include "campaign/average_columns.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

Cell cell_of(const Observables& observables, std::string_view wanted) {
  Cell cell;
  Observables::fields(observables,
                      [&](std::string_view name, const auto& member, Shape shape, Mean) {
                        if (name == wanted) cell = cell_of(member, shape);
                      });
  return cell;
}

void add_observable(std::vector<ResultColumn>& columns, const std::string& name, Shape shape) {
  const std::string type = shape == Shape::number ? "REAL" : "TEXT";
  columns.push_back({name, type, [name](const Summary& summary) {
                       return summary.averages ? cell_of(*summary.averages, name) : Cell();
                     }});
  columns.push_back({name + "_standard_error", type, [name](const Summary& summary) {
                       const bool is_known = summary.averages && summary.averages->standard_error;
                       return is_known ? cell_of(*summary.averages->standard_error, name) : Cell();
                     }});
}

/// A column of the rest of the averages.
template <class Part>
ResultColumn averages_column(std::string name, std::string type, Part part) {
  return {std::move(name), std::move(type), [part](const Summary& summary) {
            return summary.averages ? Cell(part(*summary.averages)) : Cell();
          }};
}

}  // namespace

std::vector<ResultColumn> average_columns() {
  std::vector<ResultColumn> columns;
  const Observables all;
  Observables::fields(all, [&](const char* name, const auto&, Shape shape, Mean) {
    add_observable(columns, name, shape);
  });
  const auto add = [&](const char* name, const char* type, auto part) {
    columns.push_back(averages_column(name, type, part));
  };
  add("streak_amplitude", "REAL", [](const Averages& a) { return or_null(a.streak_amplitude); });
  add("temperature_without_streak", "REAL",
      [](const Averages& a) { return or_null(a.temperature_without_streak); });
  add("averages_from_time", "REAL", [](const Averages& a) { return a.from_time; });
  add("averages_to_time", "REAL", [](const Averages& a) { return a.to_time; });
  add("averages_blocks", "INTEGER", [](const Averages& a) { return or_null(a.blocks); });
  add("averages_steady", "INTEGER",
      [](const Averages& a) { return a.steady ? Cell(std::int64_t{*a.steady}) : Cell(); });
  add("averages_steady_reason", "TEXT", [](const Averages& a) { return a.steady_reason; });
  return columns;
}

}  // namespace zenosphere
