#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "case/case_entries.hpp"

namespace zenosphere::case_format {

/// One value of a TOML text with its name, its place and what is in it.
struct TreeNode {
  std::string name;  ///< the key; empty for an item of an array
  Value value;       ///< of a table: Other
  bool is_table = false;
  Place key_place;
  Place value_place;
  std::vector<TreeNode> children;  ///< of a table or an array, in the order of the text
};

/// Most items that a tree takes from one array.
inline constexpr std::size_t most_items = 100'000;

/// The tables and keys of a TOML text, in the order of the text, to any depth but for one table.
///
/// \param name       what the places call the text
/// \param left_whole  a table at the root whose content is not looked into
/// Throws InputError, with line and column, if the text is not TOML or beyond the limits.
std::vector<TreeNode> tree_of(std::string_view text, const std::string& name,
                              std::string_view left_whole);

}  // namespace zenosphere::case_format
