#include "campaign/boundary_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "campaign/sweep.hpp"
#include "campaign/sweep_fields.hpp"

namespace zenosphere {

using case_format::Problems;
using case_format::TreeNode;

namespace {

/// What the keys of the table hold.
struct BoundaryTable {
  std::optional<std::string> axis, criterion;
  std::optional<double> from, to, resolution;
  std::int64_t runs = 200;
  std::int64_t round = 8;
};

BoundaryTable told_in(const TreeNode& table, Problems& problems) {
  constexpr double unbounded = std::numeric_limits<double>::max();
  constexpr case_format::Range finite{-unbounded, unbounded, true, ""};
  constexpr case_format::Range above_zero{0, unbounded, false, ""};
  BoundaryTable told;
  const std::array fields{
      text_field("axis", told.axis),
      text_field("criterion", told.criterion),
      number_field("from", told.from, finite),
      number_field("to", told.to, finite),
      number_field("resolution", told.resolution, above_zero),
      count_field("runs", told.runs, {2, static_cast<double>(most_runs), true, ""}),
      count_field("round", told.round, {2, 10'000, true, ""})};
  read_fields(table, "boundary.", fields, problems);
  return told;
}

/// Where the value of a key of the table stands, or the table itself.
const case_format::Place& place_of(const TreeNode& table, std::string_view name) {
  const auto is_it = [&](const TreeNode& node) { return node.name == name; };
  const auto found = std::find_if(table.children.begin(), table.children.end(), is_it);
  return found == table.children.end() ? table.key_place : found->value_place;
}

/// What is wrong with the values together, and with which key; no key: with the table.
struct WrongKey {
  std::string_view key;
  std::string text;
};

std::optional<WrongKey> objection(const BoundaryTable& told) {
  if (!told.axis || !told.criterion || !told.from || !told.to || !told.resolution) {
    return WrongKey{
        "", "boundary (needs axis, criterion, from, to and resolution); add what is missing"};
  }
  if (*told.criterion != "separation" && *told.criterion != "arrest") {
    return WrongKey{"criterion",
                    fmt::format("boundary.criterion = {} (must be \"separation\" or \"arrest\")",
                                case_format::shown(*told.criterion))};
  }
  if (!(*told.from < *told.to)) {
    return WrongKey{"to",
                    fmt::format("boundary.to = {} (must be > from = {})", *told.to, *told.from)};
  }
  constexpr double finest = 1e-3;  // of the range: the posterior is on a grid
  const double length = *told.to - *told.from;
  if (*told.resolution > length || *told.resolution < finest * length) {
    return WrongKey{
        "resolution",
        fmt::format("boundary.resolution = {} (must be in [{:.3g}, {:.3g}], parts of the range)",
                    *told.resolution, finest * length, length)};
  }
  return std::nullopt;
}

/// The numeric key of that name that is no other axis, or nothing, which was told.
std::optional<AxisKey> key_of(const std::string& path, const case_format::Place& place,
                              const std::vector<SweepAxis>& axes, Problems& problems) {
  const auto key = AxisKey::named(path);
  const auto is_it = [&](const SweepAxis& axis) { return axis.key == *key; };
  std::string why;
  if (!key) {
    const auto meant = AxisKey::nearest_path(path);
    why = fmt::format("(is no key of a case){}",
                      meant ? fmt::format("; did you mean \"{}\"?", *meant) : "");
  } else if (key->storage() == Storage::text || path == "start.seed") {
    why = "(must be a key with a number, and not the seed)";
  } else if (std::any_of(axes.begin(), axes.end(), is_it)) {
    why = "(is under [axes] too); remove it there";
  } else {
    return key;
  }
  problems.add(place, fmt::format("boundary.axis = {} {}",
                                  case_format::shown(case_format::Value(path)), why));
  return std::nullopt;
}

}  // namespace

std::optional<BoundaryRequest> boundary_of(const TreeNode& table, std::vector<SweepAxis>& axes,
                                           Problems& problems) {
  const BoundaryTable told = told_in(table, problems);
  if (const auto wrong = objection(told)) {
    problems.add(place_of(table, wrong->key), wrong->text);
    return std::nullopt;
  }
  const auto key = key_of(*told.axis, place_of(table, "axis"), axes, problems);
  if (!key) return std::nullopt;
  const Storage storage = key->storage();
  axes.push_back({*key,
                  {{in_storage(*told.from, storage), place_of(table, "from")},
                   {in_storage(*told.to, storage), place_of(table, "to")}}});
  return BoundaryRequest{.criterion = *told.criterion == "arrest"
                                          ? BoundaryRequest::Criterion::arrest
                                          : BoundaryRequest::Criterion::separation,
                         .range = {.from = *told.from,
                                   .to = *told.to,
                                   .resolution = *told.resolution,
                                   .is_whole = storage == Storage::integer,
                                   .most_runs = told.runs,
                                   .round_runs = told.round}};
}

}  // namespace zenosphere
