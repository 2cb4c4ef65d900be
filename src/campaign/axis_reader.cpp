#include "campaign/axis_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

#include "campaign/sweep.hpp"
#include "campaign/sweep_fields.hpp"

namespace zenosphere {

using case_format::Problems;
using case_format::TreeNode;
using case_format::Value;

namespace {

/// The key of an axis as messages show it: `axes."system.restitution"`.
std::string shown_path(const std::string& path) { return "axes." + case_format::key_text(path); }

/// The key of the case that an axis is over, or nothing, which was told.
std::optional<AxisKey> key_of(const std::string& path, const TreeNode& node, Problems& problems) {
  const auto key = AxisKey::named(path);
  if (!key) {
    const auto meant = AxisKey::nearest_path(path);
    problems.add(
        node.key_place,
        fmt::format("unknown key {} (an axis is over a key of the case){}", shown_path(path),
                    meant ? fmt::format("; did you mean \"{}\"?", *meant) : ""));
  } else if (path == "start.seed") {
    problems.add(node.key_place,
                 "axes.\"start.seed\" (the seed of each run follows from sweep.master_seed and its "
                 "number); remove it and raise sweep.seeds");
    return std::nullopt;
  }
  return key;
}

/// The range that a table describes, or nothing, which was told.
std::optional<AxisRange> range_of(const std::string& path, const TreeNode& node,
                                  Problems& problems) {
  constexpr double unbounded = std::numeric_limits<double>::max();
  constexpr case_format::Range finite{-unbounded, unbounded, true, ""};
  std::optional<double> from, to;
  std::optional<std::string> spacing;
  AxisRange range;
  const std::array fields{
      number_field("from", from, finite), number_field("to", to, finite),
      count_field("points", range.points, {2, static_cast<double>(most_axis_values), true, ""}),
      text_field("spacing", spacing)};
  read_fields(node, shown_path(path) + '.', fields, problems);
  const auto reject = [&](const std::string& why) {
    problems.add(node.value_place, fmt::format("{} = {{...}} {}", shown_path(path), why));
    return std::nullopt;
  };
  if (!from || !to || range.points == 0) {
    return reject("(a range needs from, to and points)");
  }
  if (spacing && *spacing != "linear" && *spacing != "log") {
    return reject("(spacing must be \"linear\" or \"log\")");
  }
  const bool is_log = spacing == "log";
  if (is_log && !(*from > 0 && *to > 0)) {
    return reject("(a log range needs from and to above 0)");
  }
  range.from = *from;
  range.to = *to;
  if (is_log) range.spacing = AxisRange::Spacing::log;
  return range;
}

/// The values of an array or a range, in the type of the key.
std::vector<AxisValue> values_of(const AxisKey& key, const TreeNode& node, Problems& problems) {
  const Storage storage = key.storage();
  const std::string path = key.path();
  std::vector<AxisValue> values;
  if (node.is_table) {
    const auto range = range_of(path, node, problems);
    if (!range) return values;
    for (Value& number : numbers_of(*range, storage)) {
      values.push_back({std::move(number), node.value_place});
    }
    return values;
  }
  const bool is_array = std::holds_alternative<case_format::Array>(node.value);
  if (!is_array || node.children.empty() || node.children.size() > most_axis_values) {
    problems.add(node.value_place,
                 fmt::format("{} = {} (needs an array of 1 to {} values, or a range {{ from, to, "
                             "points }})",
                             shown_path(path), case_format::shown(node.value), most_axis_values));
    return values;
  }
  for (const TreeNode& item : node.children) {
    values.push_back({in_storage(item.value, storage), item.value_place});
  }
  return values;
}

/// Long texts are refused here, all else that is wrong with a value by the case reader.
void check_values(const SweepAxis& axis, Problems& problems) {
  std::vector<std::string> known;
  for (const AxisValue& value : axis.values) {
    const std::string text = column_text(value.value);
    const std::string shown =
        fmt::format("{} = {}", shown_path(axis.path()), case_format::shown(value.value));
    if (text.size() > longest_text) {
      problems.add(value.place,
                   fmt::format("{} (has {} bytes, at most {})", shown, text.size(), longest_text));
    }
    known.push_back(text);
  }
  std::sort(known.begin(), known.end());
  const auto twice = std::adjacent_find(known.begin(), known.end());
  if (twice == known.end()) return;
  problems.add(axis.values.front().place,
               fmt::format("{} has {} twice; remove one", shown_path(axis.path()),
                           twice->size() > 60 ? "a value" : *twice));
}

void add_axis(const std::string& path, const TreeNode& node, std::vector<SweepAxis>& axes,
              Problems& problems) {
  const auto key = key_of(path, node, problems);
  if (!key) return;
  const auto is_it = [&](const SweepAxis& axis) { return axis.key == *key; };
  if (std::any_of(axes.begin(), axes.end(), is_it)) {
    problems.add(node.key_place, shown_path(path) + " is given twice; remove one");
    return;
  }
  SweepAxis axis{*key, values_of(*key, node, problems)};
  if (axis.values.empty()) return;
  check_values(axis, problems);
  axes.push_back(std::move(axis));
}

/// Adds the axes in a node: of one below a table of the case, `[axes.species.heavy]`, each key.
void add_axes(const std::string& path, const TreeNode& node, std::vector<SweepAxis>& axes,
              Problems& problems) {
  const std::string table = path.substr(0, path.find('.'));
  const auto parts = std::count(path.begin(), path.end(), '.') + 1;
  const bool is_of_case = case_format::is_table(table) || parts_of_path(table) > 2;
  if (!node.is_table || !is_of_case || parts >= parts_of_path(table)) {
    return add_axis(path, node, axes, problems);
  }
  for (const TreeNode& inner : node.children) {
    add_axes(path + '.' + inner.name, inner, axes, problems);
  }
}

}  // namespace

std::vector<SweepAxis> axes_of(const TreeNode& table, Problems& problems) {
  std::vector<SweepAxis> axes;
  for (const TreeNode& node : table.children) {
    add_axes(node.name, node, axes, problems);
  }
  if (axes.size() > most_axes) {
    problems.add(table.key_place,
                 fmt::format("axes has {} keys (at most {}); give fewer", axes.size(), most_axes));
  }
  return axes;
}

}  // namespace zenosphere
