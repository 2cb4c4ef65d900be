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

Place place_of(const toml::source_region& region, const std::string& name);

}  // namespace zenosphere::case_format
