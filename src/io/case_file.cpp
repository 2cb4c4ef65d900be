#include "io/case_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>
#include <vector>

#include "io/case_entries.hpp"
#include "io/case_reader.hpp"
#include "io/case_table.hpp"

namespace zenosphere {
namespace {

/// A case takes a few hundred bytes; what is larger is another file, named by mistake.
constexpr std::streamsize most_bytes = 1'048'576;

std::string content_of(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code ignored;  // what does not exist fails to open, with the reason in errno
  if (std::filesystem::is_directory(file, ignored)) {
    throw InputError(name + ": is a directory (a case is a TOML file); name the file in it");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw InputError(fmt::format("{}: cannot be opened ({}); check the name and its permissions",
                                 name, std::strerror(errno)));
  }
  std::string content(most_bytes + 1, '\0');
  stream.read(content.data(), most_bytes + 1);
  if (stream.bad()) throw InputError(name + ": cannot be read to its end; check the disk it is on");
  if (stream.gcount() > most_bytes) {
    throw InputError(name +
                     ": is larger than 1 MiB (a case takes some hundred bytes); "
                     "check that it is the case file");
  }
  content.resize(static_cast<std::size_t>(stream.gcount()));
  return content;
}

}  // namespace

Case read_case(const std::filesystem::path& file, std::span<const std::string> overrides) {
  return parse_case(content_of(file), file.string(), overrides);
}

Case parse_case(std::string text, const std::string& name, std::span<const std::string> overrides) {
  case_format::Problems problems;
  std::vector<case_format::Entry> entries = case_format::entries_of(text, name);
  for (auto& entry : case_format::entries_of(overrides, problems)) {
    std::erase_if(entries, [&](const auto& old) {
      return old.table == entry.table && old.name == entry.name;
    });
    entries.push_back(std::move(entry));
  }
  Case values = case_format::case_of(entries, name, problems);
  problems.throw_if_any();
  values.text = std::move(text);
  return values;
}

std::string resolved_toml(const Case& values) {
  std::string text;
  std::string_view table;
  for (const case_format::Key& key : case_format::keys()) {
    const auto value = case_format::toml_text(key, values);
    if (!value) continue;
    if (key.table != table) text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", key.table);
    table = key.table;
    text += fmt::format("{} = {}  # {}\n", key.name, *value, key.meaning);
  }
  return text;
}

}  // namespace zenosphere
