#include "campaign/base_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "case/case_file.hpp"

namespace zenosphere {

using case_format::Entry;
using case_format::TableHead;

namespace {

bool is_list(std::string_view table) { return parts_of_path(table) > 2; }

/// The head of a table; that of a list of tables stands in front of each of its items.
std::string head_text(const Entry& entry) {
  return is_list(entry.name) ? "" : fmt::format("[{}]\n", entry.key());
}

/// `[[species]]` with the line that names it.
std::string item_head_text(const Entry& entry) {
  const auto* label = std::get_if<std::string>(&entry.value);
  if (!label) return "";  // no name: the case reader tells
  if (entry.table == "species") {
    return fmt::format("[[species]]\nname = {}\n", case_format::in_quotes(*label));
  }
  const std::size_t dot = std::min(label->find('.'), label->size());
  return fmt::format("[[contact]]\nbetween = [{}, {}]\n",
                     case_format::in_quotes(label->substr(0, dot)),
                     case_format::in_quotes(label->substr(std::min(dot + 1, label->size()))));
}

std::string line_of(const Entry& entry, const std::string& base_name) {
  case_format::Value value = entry.value;
  auto* file = std::get_if<std::string>(&value);
  if (file && entry.key() == "start.file") *file = absolute_from(base_name, *file);
  const std::size_t label_end = is_list(entry.table) ? entry.name.rfind('.') + 1 : 0;
  return fmt::format("{} = {}\n", case_format::key_text(entry.name.substr(label_end)),
                     case_format::full_text(value));
}

bool is_varied(const Entry& entry, const std::vector<SweepAxis>& axes) {
  const auto is_over_it = [&](const SweepAxis& axis) {
    return axis.key.table() == entry.table && axis.key.name() == entry.name;
  };
  return entry.key() == "start.seed" || std::any_of(axes.begin(), axes.end(), is_over_it);
}

bool is_item_head(const Entry& entry) {
  const std::string_view key = std::string_view(entry.name).substr(entry.name.rfind('.') + 1);
  return is_list(entry.table) && key == (entry.table == "species" ? "name" : "between");
}

}  // namespace

std::string base_text_of(const CaseTemplate& base, const std::vector<SweepAxis>& axes) {
  std::string text;
  for (const Entry& entry : base.entries()) {
    if (is_item_head(entry)) {
      text += item_head_text(entry);
    } else if (std::holds_alternative<TableHead>(entry.value)) {
      text += head_text(entry);
    } else if (!is_varied(entry, axes)) {
      text += line_of(entry, base.name());
    }
  }
  return text;
}

}  // namespace zenosphere
