#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "campaign/run_columns.hpp"
#include "model/field.hpp"

namespace zenosphere {

/// The type of SQLite in which a field is kept; nothing where it is a part or a list of parts.
template <class T>
inline constexpr std::string_view column_type = std::is_enum_v<T> ? "TEXT" : "";
template <>
inline constexpr std::string_view column_type<bool> = "INTEGER";
template <>
inline constexpr std::string_view column_type<std::int64_t> = "INTEGER";
template <>
inline constexpr std::string_view column_type<double> = "REAL";
template <>
inline constexpr std::string_view column_type<std::string> = "TEXT";
template <>
inline constexpr std::string_view column_type<std::vector<std::pair<std::int64_t, std::int64_t>>> =
    "TEXT";
template <class T>
inline constexpr std::string_view column_type<std::optional<T>> = column_type<T>;

template <class T>
inline constexpr bool has_column_type = !column_type<T>.empty();

inline Cell cell_of(bool value) { return std::int64_t{value}; }
inline Cell cell_of(std::int64_t value) { return value; }
inline Cell cell_of(double value) { return value; }
inline Cell cell_of(const std::string& value) { return value; }
template <class Choice>
requires std::is_enum_v<Choice> Cell cell_of(Choice choice) { return std::string(word(choice)); }
inline Cell cell_of(const std::optional<EndedBy>& ended_by) { return std::string(word(ended_by)); }
template <class T>
Cell cell_of(const std::optional<T>& value) {
  return value ? cell_of(*value) : Cell();
}
/// `[[1, 2], [3, 4]]`
Cell cell_of(const std::vector<std::pair<std::int64_t, std::int64_t>>& pairs);

/// A field that has a column.
template <class T>
ResultColumn column_of(const Field& field, const T& member) {
  return {field.column, column_type<T>, cell_of(member)};
}

}  // namespace zenosphere
