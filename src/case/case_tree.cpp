#include "case/case_tree.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "case/case_limits.hpp"
#include "case/case_toml.hpp"

namespace zenosphere::case_format {
namespace {

/// Walks through a parsed text; how deep it can go was limited before it was parsed.
class Growth {
 public:
  explicit Growth(const std::string& name) : name_(name) {}

  std::vector<TreeNode> table(const toml::table& table, std::string_view left_whole) {
    std::vector<TreeNode> nodes;
    for (auto&& [key, node] : table) {
      if (++keys_ > most_keys) {
        throw InputError(
            fmt::format("{}: more than {} keys and tables; check that it is the file "
                        "that you mean",
                        name_, most_keys));
      }
      TreeNode grown = node.is_table() && key.str() == left_whole ? whole(node) : tree(node);
      grown.name = std::string(key.str());
      grown.key_place = place_of(key.source(), name_);
      nodes.push_back(std::move(grown));
    }
    // The library sorts by name; its user's order is that of the text.
    const auto is_before = [](const TreeNode& a, const TreeNode& b) {
      return a.key_place.order < b.key_place.order;
    };
    std::stable_sort(nodes.begin(), nodes.end(), is_before);
    return nodes;
  }

 private:
  TreeNode whole(const toml::node& node) const {
    const Place place = place_of(node.source(), name_);
    return {"", value_of(node), node.is_table(), place, place, {}};
  }

  TreeNode tree(const toml::node& node) {
    TreeNode grown = whole(node);
    if (const auto* inner = node.as_table()) grown.children = table(*inner, "");
    if (const auto* array = node.as_array()) {
      if (array->size() > most_items) {
        throw InputError(fmt::format("{}: array of {} items (at most {}); shorten it",
                                     grown.value_place.text, array->size(), most_items));
      }
      for (const toml::node& item : *array) grown.children.push_back(tree(item));
    }
    return grown;
  }

  const std::string& name_;
  std::size_t keys_ = 0;
};

}  // namespace

std::vector<TreeNode> tree_of(std::string_view text, const std::string& name,
                              std::string_view left_whole) {
  return Growth(name).table(parsed_toml(text, name), left_whole);
}

}  // namespace zenosphere::case_format
