#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>

#include "case/case_entries.hpp"

/// What the readers of TOML texts share: the parts of them that see the library.
namespace zenosphere::case_format {

/// A text as the library reads it.
///
/// \param name  what the places call it
/// Throws InputError, with line and column, if the text is not TOML or beyond the limits.
toml::table parsed_toml(std::string_view text, const std::string& name);

/// The value of a node; a table in it is one that no key can hold.
Value value_of(const toml::node& node);

/// Adds the tables of an array of tables: the key that names each first, then its others.
///
/// The key `mass` of the species "heavy" becomes `heavy.mass` of the table `species`, `restitution`
/// of the contact between "a" and "b" `a.b.restitution` of `contact`; their heads are `heavy.name`
/// and `a.b.between`, with the text that names them, what stands there instead, or, where nothing
/// does, TableHead. Items that have no name of their own are called by their number from 1.
void append_items(const toml::array& items, const std::string& table, const std::string& name,
                  std::vector<Entry>& entries);

Place place_of(const toml::source_region& region, const std::string& name);

}  // namespace zenosphere::case_format
