#include "case/case_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>
#include <vector>

#include "case/case_entries.hpp"
#include "case/case_table.hpp"
#include "case/case_template.hpp"
#include "case/species_table.hpp"
#include "text/file_kind.hpp"

namespace zenosphere {
namespace {

/// The most positions and velocities that a case may write take 15 MB with all their digits; what
/// is larger is another file, named by mistake.
constexpr std::size_t most_bytes = 16'777'216;

}  // namespace

std::string case_text(const std::filesystem::path& file) {
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
  std::string content;
  for (char block[65536]; stream && content.size() <= most_bytes;) {
    stream.read(block, sizeof block);
    content.append(block, static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) throw InputError(name + ": cannot be read to its end; check the disk it is on");
  if (content.size() > most_bytes) {
    throw InputError(name +
                     ": is larger than 16 MiB (a case with 100000 written spheres takes less); "
                     "check that it is the case file");
  }
  const FileKind kind = kind_of_file(content);
  const bool is_binary = kind == FileKind::output || kind == FileKind::store;
  if (is_binary) throw InputError(name + ": " + what_it_is(kind));
  return content;
}

std::string absolute_from(const std::string& name, const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(name).parent_path();
  return std::filesystem::absolute(folder / path).lexically_normal().string();
}

Case read_case(const std::filesystem::path& file, std::span<const std::string> overrides) {
  std::string text = case_text(file);
  if (kind_of_file(text) == FileKind::sweep) {
    throw InputError(file.string() + ": " + what_it_is(FileKind::sweep));
  }
  return parse_case(std::move(text), file.string(), overrides);
}

Case parse_case(std::string text, const std::string& name, std::span<const std::string> overrides) {
  Case values = CaseTemplate(case_format::entries_of(text, name), name).with(overrides);
  values.text = std::move(text);
  return values;
}

Case parse_written_case(std::string text, const std::string& name,
                        std::span<const std::string> overrides) {
  std::vector<case_format::Entry> entries = case_format::entries_of(text, name);
  for (auto& entry : entries) entry.key_place.text = entry.value_place.text = name;
  Case values = CaseTemplate(std::move(entries), name).with(overrides);
  values.text = std::move(text);
  return values;
}

std::string resolved_toml(const Case& values) {
  Case copy = values;  // slots point into a case that may be changed
  std::string text;
  std::string_view table;
  for (const case_format::Key& key : case_format::keys()) {
    const auto value = case_format::toml_text(key, copy);
    if (!value) continue;
    if (key.table != table) text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", key.table);
    table = key.table;
    text += fmt::format("{} = {}  # {}\n", key.name, *value, key.meaning);
  }
  return text + case_format::species_toml(values);
}

}  // namespace zenosphere
