#include "cli/citation.hpp"

#include <fmt/format.h>

#include <string_view>

#include "storage/build_info.hpp"

namespace zenosphere {
namespace {

/// What follows a key of CITATION.cff on its line.
std::string_view value_of(std::string_view key) {
  const std::string_view text = build_info::citation;
  const std::string mark = fmt::format("{}: ", key);
  const std::size_t begin = text.find(mark) + mark.size();  // no key is the end of another one
  return text.substr(begin, text.find('\n', begin) - begin);
}

}  // namespace

std::string citation_text() {
  return fmt::format(
      "{}\n\n{} ({}). {}: {}. Version {}, commit {}, {} license.\n\nzenosphere --cite bibtex "
      "prints an entry for BibTeX.",
      value_of("message"), value_of("name"), value_of("date-released").substr(0, 4),
      value_of("title"), value_of("abstract"), build_info::program_version, build_info::git_hash,
      value_of("license"));
}

std::string citation_bibtex() {
  const std::string_view date = value_of("date-released");
  return fmt::format(
      "@software{{zenosphere,\n"
      "  author  = {{{{{}}}}},\n"
      "  title   = {{{}: {}}},\n"
      "  version = {{{}}},\n"
      "  date    = {{{}}},\n"
      "  year    = {{{}}},\n"
      "  note    = {{commit {}}}\n"
      "}}",
      value_of("name"), value_of("title"), value_of("abstract"), build_info::program_version, date,
      date.substr(0, 4), build_info::git_hash);
}

}  // namespace zenosphere
