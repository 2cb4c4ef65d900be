#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "case/case_problems.hpp"

namespace zenosphere::case_format {

/// An array of numbers, of arrays of numbers, or of both.
struct Array {
  /// A number, an array of numbers, or what stands there instead, for example `text`.
  using Item = std::variant<double, std::vector<double>, std::string>;
  std::vector<Item> items;
};
/// A TOML value that no key of a case can hold.
struct Other {
  std::string shown;  ///< as in an error message, for example `{...}`
  std::string kind;   ///< for example `a table`
};
/// The head of a table; what stands in it follows as entries of its own.
struct TableHead {};
using Value = std::variant<bool, std::int64_t, double, std::string, Array, Other, TableHead>;

/// One key of a case file or of an override, with its value.
struct Entry {
  std::string table;  ///< empty for what stands above the first table, and for a table's head
  std::string name;
  Value value;
  Place key_place;
  Place value_place;

  /// `system.restitution`; parts that TOML would not take bare are quoted.
  std::string key() const;
};

/// The entries of a TOML text, tables in any order.
///
/// \param text  the whole text, UTF-8
/// \param name    what the places call it, as a rule the file's name
/// \param within  a table at the root of the text that holds the case; empty: the whole text does
/// Throws InputError, with line and column, if the text is not TOML.
std::vector<Entry> entries_of(std::string_view text, const std::string& name,
                              std::string_view within = "");

/// The entries of command-line overrides, each `KEY=VALUE` with a dotted key.
///
/// VALUE is a TOML value; what is none is taken as a bare string, so `collision.overlap=stop` needs
/// no quotes. An override without `=` or key becomes a problem.
std::vector<Entry> entries_of(std::span<const std::string> overrides, Problems& problems);

/// The value as TOML would write it, text cut after 60 bytes, longer arrays as `[...]`; real
/// numbers so that they read back to the same bits, with a point or an exponent.
std::string shown(const Value& value);

/// The same without cuts: a text that TOML reads as the value again. Single values and rows of
/// numbers are JSON too.
std::string full_text(const Value& value);

/// `a number with a fraction`, `text`: the value's type in a message.
std::string kind_of(const Value& value);

/// One part of a key as TOML writes it, quoted where it would not take it bare; cut after 60 bytes.
std::string key_text(const std::string& part);

/// Text between quotes as TOML writes it, control characters escaped.
std::string in_quotes(std::string_view text);

/// A real number as TOML writes it: shortest digits that read back to the same bits, with a point
/// or an exponent.
std::string real_text(double number);

}  // namespace zenosphere::case_format
