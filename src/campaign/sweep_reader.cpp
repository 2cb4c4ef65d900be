#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "campaign/adjudication_reader.hpp"
#include "campaign/axis_reader.hpp"
#include "campaign/base_text.hpp"
#include "campaign/boundary_reader.hpp"
#include "campaign/grid_check.hpp"
#include "campaign/sweep.hpp"
#include "campaign/sweep_fields.hpp"
#include "case/case_file.hpp"
#include "text/file_kind.hpp"
#include "text/spelling.hpp"

namespace zenosphere {

using case_format::Problems;
using case_format::TreeNode;

namespace {

constexpr std::array<std::string_view, 6> tables{"sweep", "case",     "axes",
                                                 "stop",  "boundary", "adjudicate"};

/// The largest integer of TOML and SQLite.
constexpr double most_integer = 0x1p63;

/// What the tables of a sweep file say, before the base case is read.
struct Told {
  const TreeNode* inline_case = nullptr;
  const TreeNode* sweep = nullptr;
  const TreeNode* boundary = nullptr;
  std::optional<std::string> case_file;
  std::int64_t seeds = 0;
  std::int64_t master_seed = 1;
  std::vector<SweepAxis> axes;
  StopRule stop;
  std::optional<BoundaryRequest> search;
  std::optional<AdjudicationRequest> adjudicate;
};

void read_sweep_table(const TreeNode& node, Told& told, Problems& problems) {
  told.sweep = &node;
  const std::array fields{
      text_field("case", told.case_file),
      count_field("seeds", told.seeds, {1, static_cast<double>(most_runs), true, ""}),
      count_field("master_seed", told.master_seed, {0, most_integer, true, ""})};
  read_fields(node, "sweep.", fields, problems);
}

void read_stop_table(const TreeNode& node, Told& told, Problems& problems) {
  constexpr case_format::Range above_zero{0, 1e15, false, ""};
  const std::array fields{
      number_field("collisions_per_sphere", told.stop.collisions_per_sphere, above_zero),
      number_field("wall_seconds", told.stop.wall_seconds, above_zero)};
  read_fields(node, "stop.", fields, problems);
}

void read_node(const TreeNode& node, Told& told, Problems& problems) {
  const bool is_known = std::find(tables.begin(), tables.end(), node.name) != tables.end();
  if (!is_known) {
    const auto meant = nearest(node.name, tables);
    problems.add(node.key_place,
                 fmt::format("unknown {} {}{}", node.is_table ? "table" : "key",
                             case_format::key_text(node.name),
                             meant ? fmt::format("; did you mean [{}]?", *meant) : ""));
  } else if (!node.is_table) {
    problems.add(node.value_place,
                 fmt::format("{} = {} (is a table); give its keys under [{}]", node.name,
                             case_format::shown(node.value), node.name));
  } else if (node.name == "sweep") {
    read_sweep_table(node, told, problems);
  } else if (node.name == "axes") {
    told.axes = axes_of(node, problems);
  } else if (node.name == "stop") {
    read_stop_table(node, told, problems);
  } else if (node.name == "boundary") {
    told.boundary = &node;
  } else if (node.name == "adjudicate") {
    told.adjudicate = adjudication_of(node, problems);
  } else {
    told.inline_case = &node;
  }
}

/// Whether the key is there, whatever its value.
bool has_seeds(const Told& told) {
  const auto is_it = [](const TreeNode& node) { return node.name == "seeds"; };
  return told.sweep && std::any_of(told.sweep->children.begin(), told.sweep->children.end(), is_it);
}

/// What must be there, and how much of it.
void check_whole(const Told& told, const std::string& name, Problems& problems) {
  const auto absent = case_format::Place::absent(name);
  if (told.case_file && told.inline_case) {
    problems.add(told.inline_case->key_place,
                 "case (sweep.case names a file already); remove one of them");
  }
  if (!told.case_file && !told.inline_case) {
    problems.add(absent, "missing the base case; add case = \"FILE.toml\" under [sweep]");
  }
  if (told.seeds > 0 && told.boundary) {
    problems.add(told.boundary->key_place,
                 "boundary (a search decides how many runs it needs); remove sweep.seeds");
  }
  if (told.adjudicate && told.boundary) {
    problems.add(told.boundary->key_place,
                 "boundary (a search asks for the criteria only, not for findings); remove "
                 "[adjudicate], or give a grid under [axes]");
  }
  if (!has_seeds(told) && !told.boundary) {
    problems.add(absent,
                 "missing key sweep.seeds (runs at each point of the grid); add seeds = 10 "
                 "under [sweep]");
  }
  double runs = told.search ? static_cast<double>(told.search->range.most_runs) / 2
                            : static_cast<double>(told.seeds);  // an axis that is sought has 2 ends
  for (const SweepAxis& axis : told.axes) runs *= static_cast<double>(axis.size());
  const double points = told.search ? runs / static_cast<double>(told.search->range.most_runs) : 0;
  if (points > static_cast<double>(most_searches)) {
    problems.add(absent, fmt::format("{:.4g} points to search at (at most {}); give fewer values",
                                     points, most_searches));
  }
  if (runs > static_cast<double>(most_runs)) {
    problems.add(absent, fmt::format("{:.4g} runs (at most {}); give fewer values or seeds", runs,
                                     most_runs));
  }
}

CaseTemplate base_of(const Told& told, const std::string& text, const std::string& name) {
  if (!told.case_file) return {case_format::entries_of(text, name, "case"), name};
  const std::filesystem::path folder = std::filesystem::path(name).parent_path();
  const std::string file = (folder / *told.case_file).string();
  return {case_format::entries_of(case_text(file), file), file};
}

/// Names of start files are those from the folder of the base case, wherever the store is.
void make_files_absolute(std::vector<SweepAxis>& axes, const std::string& base) {
  for (SweepAxis& axis : axes) {
    if (axis.path() != "start.file") continue;
    for (AxisValue& value : axis.values) {
      if (auto* file = std::get_if<std::string>(&value.value)) *file = absolute_from(base, *file);
    }
  }
}

/// Axes over a species or a contact that the base case does not have.
void require_items(const std::vector<SweepAxis>& axes, const CaseTemplate& base) {
  Problems problems;
  for (const SweepAxis& axis : axes) {
    const std::string table = axis.key.table();
    if (parts_of_path(table) == 2) continue;
    const std::string label = axis.key.name().substr(0, axis.key.name().rfind('.'));
    const std::string head = label + (table == "species" ? ".name" : ".between");
    const auto is_it = [&](const auto& entry) {
      return entry.table == table && entry.name == head;
    };
    if (std::any_of(base.entries().begin(), base.entries().end(), is_it)) continue;
    problems.add(axis.values.front().place,
                 fmt::format("axes.\"{}\" (the base case has no [[{}]] {}); use a name that it has",
                             axis.path(), table, label));
  }
  problems.throw_if_any();
}

}  // namespace

std::int64_t Sweep::points() const {
  std::int64_t points = 1;
  for (const SweepAxis& axis : axes) points *= static_cast<std::int64_t>(axis.size());
  return points;
}

Sweep parse_sweep(std::string text, const std::string& name) {
  Problems problems;
  Told told;
  const std::vector<TreeNode> tree = case_format::tree_of(text, name, "case");
  for (const TreeNode& node : tree) read_node(node, told, problems);
  if (told.boundary) told.search = boundary_of(*told.boundary, told.axes, problems);
  check_whole(told, name, problems);
  problems.throw_if_any();
  CaseTemplate base = base_of(told, text, name);
  make_files_absolute(told.axes, base.name());
  require_items(told.axes, base);
  std::string base_text = base_text_of(base, told.axes);
  Sweep sweep{.name = name,
              .text = std::move(text),
              .base = std::move(base),
              .base_text = std::move(base_text),
              .axes = std::move(told.axes),
              .seeds = told.seeds,
              .master_seed = told.master_seed,
              .stop = told.stop,
              .boundary = told.search,
              .adjudicate = told.adjudicate};
  check_grid(sweep);
  return sweep;
}

Sweep read_sweep(const std::filesystem::path& file) {
  std::string text = case_text(file);
  if (kind_of_file(text) == FileKind::case_file) {
    throw InputError(file.string() + ": " + what_it_is(FileKind::case_file));
  }
  return parse_sweep(std::move(text), file.string());
}

}  // namespace zenosphere
