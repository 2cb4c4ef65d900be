// The tables [[species]] and [[contact]] as entries.

#include <algorithm>
#include <cctype>
#include <optional>

#include "case/case_limits.hpp"
#include "case/case_toml.hpp"

namespace zenosphere::case_format {
namespace {

/// The text of an item's key `name`, or of its `between` as `a.b`; nothing where that is none.
std::optional<std::string> text_of(const toml::node* head) {
  if (!head) return std::nullopt;
  if (const auto* text = head->as_string()) return text->get();
  const auto* pair = head->as_array();
  if (!pair || pair->size() != 2) return std::nullopt;
  const auto* first = pair->get(0)->as_string();
  const auto* second = pair->get(1)->as_string();
  if (!first || !second) return std::nullopt;
  return first->get() + '.' + second->get();
}

bool can_be_label(const std::string& text) {
  const auto is_bare = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
  };
  return !text.empty() && text.size() < 100 && std::all_of(text.begin(), text.end(), is_bare);
}

void append_item(const toml::table& item, const std::string& table, const std::string& label,
                 const std::string& name, std::vector<Entry>& entries) {
  const std::string head_key = table == "species" ? "name" : "between";
  const toml::node* head = item.get(head_key);
  const auto head_text = text_of(head);
  const Value head_value = head_text ? Value(*head_text) : head ? value_of(*head) : TableHead{};
  const Place place = place_of(head ? head->source() : item.source(), name);
  entries.push_back({table, label + '.' + head_key, head_value, place, place});
  for (auto&& [key, node] : item) {
    if (key.str() == head_key) continue;
    entries.push_back({table, label + '.' + std::string(key.str()), value_of(node),
                       place_of(key.source(), name), place_of(node.source(), name)});
  }
}

}  // namespace

void append_items(const toml::array& items, const std::string& table, const std::string& name,
                  std::vector<Entry>& entries) {
  std::vector<std::string> labels;
  for (std::size_t n = 0; n < items.size() && n < most_keys; ++n) {
    const toml::table& item = *items.get(n)->as_table();
    const auto text = text_of(item.get(table == "species" ? "name" : "between"));
    std::string label = text && can_be_label(*text) ? *text : std::to_string(n + 1);
    if (std::find(labels.begin(), labels.end(), label) != labels.end()) {
      label = std::to_string(n + 1);
    }
    labels.push_back(label);
    append_item(item, table, label, name, entries);
  }
}

}  // namespace zenosphere::case_format
