#include "case/case_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "text/spelling.hpp"

namespace zenosphere::case_format {
namespace {

/// Calls visit(table, CaseKey, member) or visit(table, CaseKey, member, When) for each key of a
/// case, in the order of the reference page.
template <class Visitor>
void visit_keys(Case& values, const Visitor& visit) {
  values.tables([&](std::string_view table, auto& part) {
    part.keys([&](const CaseKey& key, auto& member, const auto&... when) {
      visit(table, key, member, when...);
    });
  });
}

std::vector<Key> all_keys() {
  std::vector<Key> keys;
  Case some;
  visit_keys(some, [&](std::string_view table, const CaseKey& key, auto&, const auto&... when) {
    keys.push_back({key, table, std::nullopt, keys.size()});
    ((keys.back().condition = Condition{{when.depends_on, when.and_on}, when.holds, when.text}),
     ...);
  });
  return keys;
}

}  // namespace

std::string range_text(const Range& range) {
  const auto& [low, high, low_belongs, note] = range;
  const std::string note_text = note.empty() ? "" : fmt::format("; {}", note);
  if (low == high) return fmt::format("must be {}{}", low, note_text);
  if (high == infinite) return fmt::format("must be {} {}", low_belongs ? ">=" : ">", low);
  return fmt::format("must be in {}{}, {}]{}", low_belongs ? "[" : "(", low, high, note_text);
}

std::span<const Key> keys() {
  static const std::vector<Key> keys = all_keys();
  return keys;
}

Slot Key::slot(Case& values) const {
  std::size_t passed = 0;
  Slot slot;
  visit_keys(values, [&](std::string_view, const CaseKey&, auto& member, const auto&...) {
    if (passed++ == number) slot = &member;
  });
  return slot;
}

const Key* key_named(std::string_view table, std::string_view name) {
  const auto is_it = [&](const Key& key) { return key.table == table && key.name == name; };
  const auto found = std::find_if(keys().begin(), keys().end(), is_it);
  return found == keys().end() ? nullptr : &*found;
}

bool is_table(std::string_view name) {
  const auto is_in_it = [&](const Key& key) { return key.table == name; };
  return std::any_of(keys().begin(), keys().end(), is_in_it);
}

const Key* nearest_key(std::string_view table, std::string_view name) {
  std::vector<std::string_view> neighbours;
  std::vector<std::string_view> names;
  for (const Key& key : keys()) {
    names.push_back(key.name);
    if (key.table == table) neighbours.push_back(key.name);
  }
  if (const auto neighbour = nearest(name, neighbours)) return key_named(table, *neighbour);
  const auto meant = nearest(name, names);
  const auto is_it = [&](const Key& key) { return key.name == meant; };
  return meant ? &*std::find_if(keys().begin(), keys().end(), is_it) : nullptr;
}

std::optional<std::string_view> nearest_table(std::string_view name) {
  std::vector<std::string_view> tables;
  tables.reserve(keys().size());
  for (const Key& key : keys()) tables.push_back(key.table);
  return nearest(name, tables);
}

}  // namespace zenosphere::case_format
