#include "case/case_entries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <type_traits>
#include <utility>

#include "case/case_limits.hpp"
#include "case/case_numbers.hpp"
#include "case/case_toml.hpp"
#include "text/printable.hpp"

namespace zenosphere::case_format {
namespace {

bool is_bare(std::string_view part) {
  const auto bare = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
  return !part.empty() && std::all_of(part.begin(), part.end(), bare);
}

/// An override as the command line has it, on one line whatever it holds.
std::string override_text(const std::string& text) {
  const auto control = [](unsigned char c) { return std::iscntrl(c) != 0; };
  return "--set " + (std::any_of(text.begin(), text.end(), control) ? in_quotes(text) : text);
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

/// A number of any kind; an integer beyond 2^53, which no key takes, becomes the double nearest.
double number_in(const toml::node& node) {
  if (const auto* integer = node.as_integer()) return static_cast<double>(integer->get());
  return node.as_floating_point()->get();
}

/// The numbers of an array, or nothing if something else is in it.
std::optional<std::vector<double>> numbers_of(const toml::array& array) {
  std::vector<double> numbers;
  numbers.reserve(array.size());
  for (const toml::node& node : array) {
    if (!node.is_number()) return std::nullopt;
    numbers.push_back(number_in(node));
  }
  return numbers;
}

Array::Item item_of(const toml::node& node) {
  if (const auto* array = node.as_array()) {
    if (auto numbers = numbers_of(*array)) return *std::move(numbers);
    return "an array with more than numbers in it";
  }
  if (node.is_number()) return number_in(node);
  return kind_of(value_of(node));
}

Array array_of(const toml::array& array) {
  Array result;
  result.items.reserve(array.size());
  for (const toml::node& node : array) result.items.push_back(item_of(node));
  return result;
}

/// Throws where a file has so many keys that it is none of a case: each would be a problem.
void require_few(std::size_t keys, const std::string& name) {
  if (keys < most_keys) return;
  throw InputError(fmt::format("{}: more than {} keys and tables; check that it is the case file",
                               name, most_keys));
}

void append_table(const toml::table& table, const std::string& table_name, const std::string& name,
                  std::vector<Entry>& entries) {
  for (auto&& [key, node] : table) {
    require_few(entries.size(), name);
    entries.push_back({table_name, std::string(key.str()), value_of(node),
                       place_of(key.source(), name), place_of(node.source(), name)});
  }
}

std::string lower_case_start(std::string_view text) {
  std::string lowered(text);
  if (!lowered.empty()) lowered[0] = static_cast<char>(std::tolower(lowered[0]));
  return lowered;
}

/// The TOML value that `text` is as a whole, or nothing.
std::optional<Value> toml_value(const std::string& text) {
  if (excess_in(text)) return std::nullopt;
  try {
    const toml::table parsed = toml::parse("value = " + text, std::string_view{});
    if (parsed.size() != 1) return std::nullopt;  // `text` held lines of its own
    return value_of(*parsed.get("value"));
  } catch (const toml::parse_error&) {
    return std::nullopt;
  }
}

}  // namespace

Value value_of(const toml::node& node) {
  if (const auto* boolean = node.as_boolean()) return boolean->get();
  if (const auto* integer = node.as_integer()) return integer->get();
  if (const auto* real = node.as_floating_point()) return real->get();
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* array = node.as_array()) return array_of(*array);
  if (node.is_table()) return Other{"{...}", "a table"};
  return Other{"...", "a date or time"};
}

Place place_of(const toml::source_region& region, const std::string& name) {
  return Place::in_file(name, region.begin.line, region.begin.column);
}

std::string key_text(const std::string& part) {
  return shortened(is_bare(part) ? part : in_quotes(part));
}

toml::table parsed_toml(std::string_view text, const std::string& name) {
  if (const auto excess = excess_in(text)) {
    throw InputError(
        fmt::format("{}: {}", Place::in_file(name, excess->line, 1).text, excess->what));
  }
  if (const auto wrong = first_wrong_number(text)) {
    const std::string_view before = text.substr(0, wrong->at);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t begin = before.rfind('\n') + 1;  // 0 in the first line
    const auto column = static_cast<std::int64_t>(wrong->at - begin) + 1;
    throw InputError(
        fmt::format("{}: {}", Place::in_file(name, line, column).text, wrong->objection));
  }
  try {
    return toml::parse(text, std::string_view{});
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}: not valid TOML ({})", place_of(error.source(), name).text,
                                 lower_case_start(error.description())));
  }
}

std::string Entry::key() const {
  return table.empty() ? key_text(name) : key_text(table) + "." + key_text(name);
}

std::vector<Entry> entries_of(std::string_view text, const std::string& name,
                              std::string_view within) {
  const toml::table parsed = parsed_toml(text, name);
  const toml::table* root = within.empty() ? &parsed : parsed[within].as_table();
  std::vector<Entry> entries;
  if (!root) return entries;
  for (auto&& [key, node] : *root) {
    require_few(entries.size(), name);
    const bool is_list =
        node.is_array_of_tables() && (key.str() == "species" || key.str() == "contact");
    const bool is_table = node.is_table() || is_list;
    const Value value = is_table ? Value(TableHead{}) : value_of(node);
    entries.push_back({"", std::string(key.str()), value, place_of(key.source(), name),
                       place_of(node.source(), name)});
    if (const auto* table = node.as_table()) {
      append_table(*table, std::string(key.str()), name, entries);
    }
    if (is_list) {
      append_items(*node.as_array(), std::string(key.str()), name, entries);
    }
  }
  return entries;
}

std::vector<Entry> entries_of(std::span<const std::string> overrides, Problems& problems) {
  if (overrides.size() > most_keys) {
    throw InputError(fmt::format("--set: {} overrides (must be at most {}); write a case file",
                                 overrides.size(), most_keys));
  }
  std::vector<Entry> entries;
  for (std::size_t n = 0; n < overrides.size(); ++n) {
    const std::string& text = overrides[n];
    const Place place = Place::in_override(override_text(text), static_cast<std::int64_t>(n));
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || trimmed(text.substr(0, equals)).empty()) {
      problems.add(place, "not an override (needs KEY=VALUE); write system.restitution=0.2");
      continue;
    }
    const std::string key = trimmed(text.substr(0, equals));
    const std::string written = trimmed(text.substr(equals + 1));
    if (const auto wrong = first_wrong_number("= " + written)) {
      problems.add(place, fmt::format("{} = {}", key, wrong->objection));
      continue;
    }
    const std::size_t dot = key.find('.');
    const bool dotted = dot != std::string::npos;
    entries.push_back({dotted ? key.substr(0, dot) : "", dotted ? key.substr(dot + 1) : key,
                       toml_value(written).value_or(Value(written)), place, place});
  }
  return entries;
}

namespace {

std::string numbers_text(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) {
    if (text.size() > longest_shown) break;  // the rest is not shown
    text += fmt::format("{}{}", text.empty() ? "" : ", ", number);
  }
  return '[' + text + ']';
}

std::string array_text(const Array& array) {
  std::string text;
  for (const Array::Item& item : array.items) {
    if (!text.empty()) text += ", ";
    if (const auto* number = std::get_if<double>(&item)) text += fmt::format("{}", *number);
    if (const auto* row = std::get_if<std::vector<double>>(&item)) text += numbers_text(*row);
    const bool is_other = std::holds_alternative<std::string>(item);
    if (is_other || text.size() > longest_shown) return "[...]";
  }
  return '[' + text + ']';
}

}  // namespace

std::string shown(const Value& value) {
  const auto text = [](const auto& held) -> std::string {
    using Held = std::decay_t<decltype(held)>;
    if constexpr (std::is_same_v<Held, std::string>) return in_quotes(shortened(held));
    if constexpr (std::is_same_v<Held, double>) return real_text(held);
    if constexpr (std::is_same_v<Held, Array>) return array_text(held);
    if constexpr (std::is_same_v<Held, Other>) return held.shown;
    if constexpr (std::is_same_v<Held, TableHead>) return "{...}";
    if constexpr (std::is_arithmetic_v<Held>) return fmt::format("{}", held);
  };
  return std::visit(text, value);
}

namespace {

std::string full_row(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ", ") + real_text(number);
  return '[' + text + ']';
}

/// Rows on lines of their own: a line has a longest length.
std::string full_array(const Array& array) {
  std::string text;
  for (const Array::Item& item : array.items) {
    const auto* row = std::get_if<std::vector<double>>(&item);
    if (!text.empty()) text += row ? ",\n" : ", ";
    if (const auto* number = std::get_if<double>(&item)) text += real_text(*number);
    if (row) text += full_row(*row);
    if (const auto* other = std::get_if<std::string>(&item)) text += in_quotes(*other);
  }
  return '[' + text + ']';
}

}  // namespace

std::string full_text(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return in_quotes(*text);
  if (const auto* array = std::get_if<Array>(&value)) return full_array(*array);
  return shown(value);
}

std::string kind_of(const Value& value) {
  if (std::holds_alternative<bool>(value)) return "true or false";
  if (std::holds_alternative<std::int64_t>(value)) return "an integer";
  if (std::holds_alternative<double>(value)) return "a real number";
  if (std::holds_alternative<std::string>(value)) return "text";
  if (std::holds_alternative<Array>(value)) return "an array";
  if (const auto* other = std::get_if<Other>(&value)) return other->kind;
  return "a table";
}

std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const bool is_control = static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
    if (c == '"' || c == '\\') {
      result += {'\\', c};
    } else if (is_control) {
      result += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string real_text(double number) {
  const std::string digits = fmt::format("{}", number);
  return digits.find_first_of(".en") == std::string::npos ? digits + ".0" : digits;
}

}  // namespace zenosphere::case_format
