#include "campaign/axis_key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <span>
#include <type_traits>
#include <variant>
#include <vector>

#include "case/species_table.hpp"
#include "text/spelling.hpp"

namespace zenosphere {

using case_format::ItemKey;
using case_format::Slot;

namespace {

/// `species.heavy.mass` as its table, the label of the item (`heavy`, of a contact `a.b`), and the
/// key; a key of an ordinary table has no label.
struct Path {
  std::string_view table, label, key;

  explicit Path(std::string_view path) {
    const std::size_t first = std::min(path.find('.'), path.size());
    table = path.substr(0, first);
    key = path.substr(std::min(first + 1, path.size()));
    const std::size_t last = key.rfind('.');
    if (parts_of_path(table) == 2 || last == std::string_view::npos) return;
    label = key.substr(0, last);
    key = key.substr(last + 1);
  }

  /// Whether the label can be that of an item of the table: one name, or two with a dot between.
  bool is_of_item() const {
    const auto is_bare = [](unsigned char c) {
      return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
    };
    return !label.empty() && std::all_of(label.begin(), label.end(), is_bare) &&
           std::count(label.begin(), label.end(), '.') == parts_of_path(table) - 3;
  }
};

template <class Item>
std::optional<Storage> storage_in(std::span<const ItemKey<Item>> keys, std::string_view name) {
  Item untouched;
  const auto is_it = [&](const auto& key) { return key.name == name; };
  const auto key = std::find_if(keys.begin(), keys.end(), is_it);
  return key == keys.end() ? std::nullopt : std::optional(storage_of(key->slot(untouched)));
}

std::optional<Storage> item_storage(const Path& path) {
  if (!path.is_of_item()) return std::nullopt;
  return path.table == "species" ? storage_in(case_format::species_keys(), path.key)
                                 : storage_in(case_format::contact_keys(), path.key);
}

std::vector<std::string_view> item_key_names(std::string_view table) {
  std::vector<std::string_view> names;
  if (table == "species") {
    for (const auto& key : case_format::species_keys()) names.push_back(key.name);
  } else {
    for (const auto& key : case_format::contact_keys()) names.push_back(key.name);
  }
  return names;
}

}  // namespace

Storage storage_of(const Slot& slot) {
  const auto storage = [](auto* held) {
    using Held = std::remove_pointer_t<decltype(held)>;
    constexpr bool is_real =
        std::is_same_v<Held, double> || std::is_same_v<Held, std::optional<double>>;
    constexpr bool is_count = (std::is_integral_v<Held> && !std::is_same_v<Held, bool>) ||
                              std::is_same_v<Held, std::optional<std::int64_t>>;
    return is_real ? Storage::real : is_count ? Storage::integer : Storage::text;
  };
  return std::visit(storage, slot);
}

int parts_of_path(std::string_view table) {
  return table == "species" ? 3 : table == "contact" ? 4 : 2;
}

std::optional<AxisKey> AxisKey::named(std::string_view path) {
  const Path parts(path);
  if (parts_of_path(parts.table) > 2) {
    const auto storage = item_storage(parts);
    if (!storage) return std::nullopt;
    return AxisKey(parts.table, path.substr(parts.table.size() + 1), *storage, false);
  }
  Case untouched;
  const case_format::Key* key = case_format::key_named(parts.table, parts.key);
  if (!key) return std::nullopt;
  const Slot slot = key->slot(untouched);
  const bool is_file_name = std::holds_alternative<std::string*>(slot);
  return AxisKey(key->table, key->name, storage_of(slot), is_file_name);
}

std::optional<std::string> AxisKey::nearest_path(std::string_view path) {
  const Path parts(path);
  if (parts_of_path(parts.table) > 2) {
    const auto meant = nearest(parts.key, item_key_names(parts.table));
    if (!meant || !parts.is_of_item()) return std::nullopt;
    return fmt::format("{}.{}.{}", parts.table, parts.label, *meant);
  }
  const case_format::Key* meant =
      case_format::nearest_key(parts.table, parts.key.empty() ? path : parts.key);
  return meant ? std::optional(meant->path()) : std::nullopt;
}

std::string AxisKey::override_of(const std::string& column) const {
  return fmt::format("{}={}", path(), is_file_name_ ? case_format::in_quotes(column) : column);
}

}  // namespace zenosphere
