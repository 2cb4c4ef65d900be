#include "text/file_kind.hpp"

#include <fstream>

namespace zenosphere {
namespace {

/// Whether a line of a text begins with the head of a table.
bool has_table(std::string_view text, std::string_view head) {
  for (std::size_t at = text.find(head); at != std::string_view::npos;
       at = text.find(head, at + 1)) {
    if (at == 0 || text[at - 1] == '\n') return true;
  }
  return false;
}

}  // namespace

FileKind kind_of_file(std::string_view beginning) {
  if (beginning.starts_with("\x89HDF\r\n\x1a\n")) return FileKind::output;
  if (beginning.starts_with("SQLite format 3")) return FileKind::store;
  if (has_table(beginning, "[sweep]")) return FileKind::sweep;
  if (has_table(beginning, "[system]")) return FileKind::case_file;
  return FileKind::other;
}

FileKind kind_of_file_at(const std::filesystem::path& file) {
  constexpr std::size_t enough = 65536;  // tables of cases and sweeps stand near the top
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return FileKind::other;
  std::ifstream stream(file, std::ios::binary);
  std::string beginning(enough, '\0');
  stream.read(beginning.data(), static_cast<std::streamsize>(enough));
  beginning.resize(static_cast<std::size_t>(stream.gcount()));
  return kind_of_file(beginning);
}

std::string what_it_is(FileKind kind) {
  switch (kind) {
    case FileKind::output:
      return "is an HDF5 file, as runs make them; zenosphere info, resume, verify, adjudicate, "
             "export, report, figures and movie read such files";
    case FileKind::store:
      return "is an SQLite file, as sweeps make them; zenosphere sweep csv, sweep show, report and "
             "ensemble read such files";
    case FileKind::sweep:
      return "is a sweep file; zenosphere sweep runs it";
    case FileKind::case_file:
      return "is a case file; zenosphere run runs it";
    case FileKind::other:
      break;
  }
  return "";
}

}  // namespace zenosphere
