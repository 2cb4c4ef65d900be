#include "campaign/run_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

#include "campaign/average_columns.hpp"
#include "campaign/column_cell.hpp"
#include "storage/build_info.hpp"

namespace zenosphere {
namespace {

/// Adds the columns of the fields of a part, and of the parts in it.
template <HasFields Part>
void add_columns(const Part& part, std::vector<ResultColumn>& columns) {
  Part::fields(part, [&]<class T>(const Field& field, const T& member) {
    if constexpr (std::is_same_v<T, std::optional<Averages>>) {
      add_average_columns(member, columns);
    } else if constexpr (has_column_type<T>) {
      if (field.column) columns.push_back(column_of(field, member));
    } else if constexpr (HasFields<T>) {
      add_columns(member, columns);
    }
  });
}

/// In every format of the store how a run has ended comes first, not where JSON has it.
void put_in_order(std::vector<ResultColumn>& columns) {
  auto place = columns.begin();
  for (const std::string_view name : {"outcome", "ended_by", "verdict"}) {
    const auto found = std::ranges::find(columns, name, &ResultColumn::name);
    std::rotate(place++, found, found + 1);
  }
}

}  // namespace

std::vector<ResultColumn> result_columns(const Summary& summary) {
  std::vector<ResultColumn> columns;
  add_columns(summary, columns);
  put_in_order(columns);
  columns.push_back({"program_version", "TEXT", std::string(build_info::program_version)});
  columns.push_back({"git_hash", "TEXT", std::string(build_info::git_hash)});
  return columns;
}

std::span<const ResultColumn> result_columns() {
  static const std::vector<ResultColumn> columns = result_columns(Summary());
  return columns;
}

}  // namespace zenosphere
