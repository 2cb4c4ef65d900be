#include "campaign/adjudication_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "campaign/sweep_fields.hpp"

namespace zenosphere {

using case_format::Problems;
using case_format::TreeNode;
using case_format::Value;

namespace {

/// Takes the word of a precision into `slot`.
SweepField precision_field(std::string_view name, std::optional<Precision>& slot) {
  return {name, [&slot](const Value& value) -> std::optional<std::string> {
            const auto* text = std::get_if<std::string>(&value);
            if (text) slot = Precision::from_word(*text);
            if (slot) return std::nullopt;
            return fmt::format(
                R"((must be "double", "extended", "quad" or "digitsN" with N from {} to {}))",
                fewest_digits, most_digits);
          }};
}

/// Zero stands for a key that is not there.
std::optional<std::int64_t> above_zero(std::int64_t count) {
  return count > 0 ? std::optional(count) : std::nullopt;
}

}  // namespace

AdjudicationRequest adjudication_of(const TreeNode& table, Problems& problems) {
  constexpr case_format::Range counts{1, 0x1p52, true, ""};
  AdjudicationRequest request;
  std::int64_t groups = 0;
  std::int64_t collisions = 0;
  std::optional<double> seconds;
  const std::array fields{
      count_field("groups", groups, counts), number_field("seconds", seconds, {0, 1e9, false, ""}),
      precision_field("up_to", request.up_to), count_field("collisions", collisions, counts)};
  read_fields(table, "adjudicate.", fields, problems);
  request.groups = above_zero(groups);
  request.collisions = above_zero(collisions);
  request.seconds = seconds.value_or(request.seconds);
  for (const TreeNode& node : table.children) {
    if (node.name == "up_to") request.place = node.value_place.text;
  }
  return request;
}

}  // namespace zenosphere
