#include "start/xyz_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "case/case_entries.hpp"
#include "model/errors.hpp"

namespace zenosphere::xyz {
namespace {

constexpr std::size_t longest_line = 1'048'576;  ///< bytes: ten thousand columns with all digits
constexpr std::uintmax_t most_bytes = 68'719'476'736;  ///< 10^8 spheres with all digits take 14e9

}  // namespace

Lines::Lines(const std::filesystem::path& path) : name_(path.string()) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) reject_file("is a directory; name the file in it");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    reject_file("is not a regular file (it is read twice); copy it to one");
  }
  if (fs::is_regular_file(status) && fs::file_size(path, ignored) > most_bytes) {
    reject_file("is larger than 64 GiB; keep the last frame only");
  }
  stream_.open(path, std::ios::binary);
  if (stream_) return;
  reject_file(fmt::format("cannot be opened ({}); check the name and its permissions",
                          std::strerror(errno)));
}

const std::string* Lines::next() {
  line_.clear();
  ++number_;
  auto* buffer = stream_.rdbuf();
  int byte = buffer->sbumpc();
  if (byte == EOF) return nullptr;
  for (; byte != EOF && byte != '\n'; byte = buffer->sbumpc()) {
    if (line_.size() == longest_line) reject("line of more than 1 MiB (is this a text file?)");
    line_ += static_cast<char>(byte);
  }
  if (!line_.empty() && line_.back() == '\r') line_.pop_back();
  return &line_;
}

const std::string& Lines::required() {
  const std::string* line = next();
  if (!line) reject("the file ends (it has been changed meanwhile); try again");
  return *line;
}

Lines::Mark Lines::mark() { return {stream_.rdbuf()->pubseekoff(0, std::ios::cur), number_}; }

void Lines::go_back(const Mark& mark) {
  stream_.rdbuf()->pubseekpos(mark.position);
  number_ = mark.number;
}

void Lines::reject(const std::string& text) const {
  throw InputError(fmt::format("{}:{}: {}", name_, number_, text));
}

void Lines::reject_file(const std::string& text) const {
  throw InputError(fmt::format("{}: {}", name_, text));
}

std::string_view next_word(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

std::string shown(std::string_view word) {
  return case_format::shown(case_format::Value(std::string(word)));
}

double finite_number(std::string_view word, const Lines& lines) {
  if (word.empty()) lines.reject("has too few numbers");
  const auto number = number_in<double>(word);
  if (!number || !std::isfinite(*number)) {
    lines.reject(
        fmt::format("found {}, needs a finite number that a double can hold", shown(word)));
  }
  return *number;
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  const auto lower = [](unsigned char c) { return static_cast<char>(std::tolower(c)); };
  std::transform(result.begin(), result.end(), result.begin(), lower);
  return result;
}

}  // namespace zenosphere::xyz
