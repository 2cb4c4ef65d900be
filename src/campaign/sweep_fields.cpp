#include "campaign/sweep_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "campaign/axis.hpp"
#include "text/spelling.hpp"

namespace zenosphere {

using case_format::Range;
using case_format::Value;

namespace {

using Objection = std::optional<std::string>;

Objection needs(const Value& value, std::string_view what) {
  return fmt::format("(found {}, needs {})", case_format::kind_of(value), what);
}

Objection outside(double number, const Range& range) {
  if (!std::isfinite(number)) return "(must be a finite number)";
  if (!range.contains(number)) return fmt::format("({})", case_format::range_text(range));
  return std::nullopt;
}

}  // namespace

SweepField count_field(std::string_view name, std::int64_t& slot, Range range) {
  return {name, [&slot, range](const Value& given) -> Objection {
            const Value value = in_storage(given, Storage::integer);
            const auto* number = std::get_if<std::int64_t>(&value);
            if (!number) return needs(given, "an integer");
            if (auto wrong = outside(static_cast<double>(*number), range)) return wrong;
            slot = *number;
            return std::nullopt;
          }};
}

SweepField number_field(std::string_view name, std::optional<double>& slot, Range range) {
  return {name, [&slot, range](const Value& given) -> Objection {
            const Value value = in_storage(given, Storage::real);
            const auto* number = std::get_if<double>(&value);
            if (!number) return needs(given, "a number");
            if (auto wrong = outside(*number, range)) return wrong;
            slot = *number;
            return std::nullopt;
          }};
}

SweepField text_field(std::string_view name, std::optional<std::string>& slot) {
  return {name, [&slot](const Value& value) -> Objection {
            const auto* text = std::get_if<std::string>(&value);
            if (!text) return needs(value, "text");
            if (text->empty()) return "(is empty)";
            if (text->size() > longest_text) {
              return fmt::format("(has {} bytes, at most {})", text->size(), longest_text);
            }
            slot = *text;
            return std::nullopt;
          }};
}

void read_fields(const case_format::TreeNode& table, const std::string& prefix,
                 std::span<const SweepField> fields, case_format::Problems& problems) {
  for (const case_format::TreeNode& node : table.children) {
    const auto is_it = [&](const SweepField& field) { return field.name == node.name; };
    const auto field = std::find_if(fields.begin(), fields.end(), is_it);
    if (field != fields.end()) {
      const auto objection = field->take(node.value);
      if (!objection) continue;
      problems.add(node.value_place, fmt::format("{}{} = {} {}", prefix, node.name,
                                                 case_format::shown(node.value), *objection));
      continue;
    }
    std::vector<std::string_view> names;
    for (const SweepField& known : fields) names.push_back(known.name);
    const auto meant = nearest(node.name, names);
    problems.add(node.key_place,
                 fmt::format("unknown key {}{}{}", prefix, case_format::key_text(node.name),
                             meant ? fmt::format("; did you mean {}?", *meant) : ""));
  }
}

}  // namespace zenosphere
