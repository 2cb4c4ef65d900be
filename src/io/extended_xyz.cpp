#include "io/extended_xyz.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include "io/case_entries.hpp"
#include "model/errors.hpp"
#include "model/limits.hpp"

namespace zenosphere {
namespace {

constexpr std::size_t longest_line = 1'048'576;  ///< bytes: ten thousand columns with all digits
constexpr std::uintmax_t most_bytes = 68'719'476'736;  ///< 10^8 spheres with all digits take 14e9
constexpr std::size_t most_columns = 10'000;
constexpr double touching = 1e-12;  ///< diameters: what rounding leaves of a zero

/// The lines of a file, counted from 1.
class Lines {
 public:
  struct Mark {
    std::streampos position;
    std::int64_t number;
  };

  explicit Lines(const std::filesystem::path& path) : name_(path.string()) {
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

  /// The next line without its end, or null after the last one.
  const std::string* next() {
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

  /// The next line of a file that had it when it was last looked at.
  const std::string& required() {
    const std::string* line = next();
    if (!line) reject("the file ends (it has been changed meanwhile); try again");
    return *line;
  }

  Mark mark() { return {stream_.rdbuf()->pubseekoff(0, std::ios::cur), number_}; }
  void go_back(const Mark& mark) {
    stream_.rdbuf()->pubseekpos(mark.position);
    number_ = mark.number;
  }

  /// Throws an InputError about the line that was read last.
  [[noreturn]] void reject(const std::string& text) const {
    throw InputError(fmt::format("{}:{}: {}", name_, number_, text));
  }
  [[noreturn]] void reject_file(const std::string& text) const {
    throw InputError(fmt::format("{}: {}", name_, text));
  }

 private:
  std::string name_;
  std::ifstream stream_;
  std::string line_;
  std::int64_t number_ = 0;
};

constexpr std::string_view blanks = " \t";

/// Cuts the first word off a text; empty if there is none.
std::string_view next_word(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

std::string shown(std::string_view word) {
  return case_format::shown(case_format::Value(std::string(word)));
}

template <class Number>
std::optional<Number> number_in(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool is_whole = !word.empty() && end == word.data() + word.size();
  return error == std::errc() && is_whole ? std::optional(number) : std::nullopt;
}

double finite_number(std::string_view word, const Lines& lines) {
  const auto number = number_in<double>(word);
  if (word.empty()) lines.reject("has too few numbers");
  if (!number || !std::isfinite(*number)) {
    lines.reject(fmt::format("found {}, needs a finite number", shown(word)));
  }
  return *number;
}

/// The number of spheres that the first line of a frame tells.
std::int64_t spheres_in(std::string_view line, const Lines& lines) {
  const std::string_view word = next_word(line);
  const auto spheres = number_in<std::int64_t>(word);
  if (!spheres || !next_word(line).empty()) {
    lines.reject("found no number of spheres (extended XYZ begins each frame with it)");
  }
  if (*spheres < 1 || *spheres > most_spheres) {
    lines.reject(fmt::format("{} spheres (must be in [1, {}])", *spheres, most_spheres));
  }
  return *spheres;
}

/// Finds where the last frame begins; checks of all only that they have their lines.
Lines::Mark last_frame(Lines& lines) {
  std::optional<Lines::Mark> last;
  for (;;) {
    const Lines::Mark here = lines.mark();
    const std::string* line = lines.next();
    if (!line) break;
    if (line->find_first_not_of(blanks) == std::string::npos) continue;
    last = here;
    const std::int64_t needed = spheres_in(*line, lines) + 1;
    for (std::int64_t read = 0; read < needed; ++read) {
      if (lines.next()) continue;
      lines.reject(fmt::format("the file ends (the frame that begins in line {} needs {} lines)",
                               here.number + 1, needed + 1));
    }
  }
  if (!last) lines.reject_file("is empty (needs a frame of extended XYZ)");
  return *last;
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  const auto lower = [](unsigned char c) { return static_cast<char>(std::tolower(c)); };
  std::transform(result.begin(), result.end(), result.begin(), lower);
  return result;
}

/// The value of `key=value` or `key="value"` in the second line of a frame; keys in any case.
std::optional<std::string> value_of(std::string_view key, std::string_view line) {
  for (;;) {
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    if (line.empty()) return std::nullopt;
    const std::size_t end = std::min(line.find_first_of(" \t="), line.size());
    const std::string found = lower_case(line.substr(0, end));
    line.remove_prefix(end);
    if (!line.starts_with('=')) continue;
    line.remove_prefix(1);
    const bool is_quoted = line.starts_with('"');
    if (is_quoted) line.remove_prefix(1);
    const std::size_t length = std::min(line.find_first_of(is_quoted ? "\"" : blanks), line.size());
    if (found == key) return std::string(line.substr(0, length));
    line.remove_prefix(std::min(length + (is_quoted ? 1 : 0), line.size()));
  }
}

/// Sides of the box that `Lattice="..."` tells, or none.
std::vector<double> sides_in(std::string_view comment, int dimension, const Lines& lines) {
  const auto lattice = value_of("lattice", comment);
  if (!lattice) return {};
  std::string_view rest = *lattice;
  std::vector<double> sides;
  for (int n = 0; n < 9; ++n) {
    const double edge = finite_number(next_word(rest), lines);
    const bool on_diagonal = n % 4 == 0;
    if (!on_diagonal && std::abs(edge) > touching) {
      lines.reject(
          fmt::format("Lattice has {} beside its diagonal (the box must be upright)", edge));
    }
    if (on_diagonal && n / 4 < dimension) sides.push_back(edge);
  }
  return sides;
}

/// Where the numbers of a sphere stand in its line.
struct Columns {
  std::size_t position = 1;
  std::size_t position_count = 3;
  std::size_t velocity = 0;
  std::size_t velocity_count = 0;  ///< 0: there are no velocities
};

/// Cuts the next part off `species:S:1:pos:R:3`.
std::string_view next_part(std::string_view& text) {
  const std::string_view part = text.substr(0, text.find(':'));
  text.remove_prefix(std::min(part.size() + 1, text.size()));
  return part;
}

bool is_velocity(const std::string& name) {
  constexpr std::array<std::string_view, 4> names{"velo", "vel", "velocity", "velocities"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

Columns columns_in(std::string_view comment, int dimension, const Lines& lines) {
  const auto properties = value_of("properties", comment);
  if (!properties) return {};
  Columns columns{.position_count = 0};
  std::string_view rest = *properties;
  for (std::size_t column = 0; !rest.empty();) {
    const std::string name = lower_case(next_part(rest));
    next_part(rest);  // the type: what is read must be a number anyway
    const std::string_view written = next_part(rest);
    const auto count = number_in<std::size_t>(written);
    if (!count || *count < 1 || *count > most_columns || column > most_columns) {
      lines.reject(fmt::format("Properties: column {} has the count {} (must be in [1, {}])",
                               shown(name), shown(written), most_columns));
    }
    if (name == "pos")
      std::tie(columns.position, columns.position_count) = std::pair(column, *count);
    if (is_velocity(name)) {
      std::tie(columns.velocity, columns.velocity_count) = std::pair(column, *count);
    }
    column += *count;
  }
  const auto fits = [&](std::size_t count) {
    return count >= static_cast<std::size_t>(dimension) && count <= 3;
  };
  if (!fits(columns.position_count)) lines.reject("Properties has no pos:R:3; add the positions");
  if (columns.velocity_count > 0 && !fits(columns.velocity_count)) {
    lines.reject("Properties has velocities that are not velo:R:3");
  }
  return columns;
}

/// Appends the first `dimension` of the numbers that begin in a column; the others must be 0.
void append_numbers(const std::vector<std::string_view>& words, std::size_t column,
                    std::size_t count, int dimension, std::vector<double>& numbers,
                    const Lines& lines) {
  for (std::size_t n = 0; n < count; ++n) {
    const bool is_there = column + n < words.size();
    const double number = finite_number(is_there ? words[column + n] : "", lines);
    if (n < static_cast<std::size_t>(dimension)) {
      numbers.push_back(number);
    } else if (number != 0) {
      lines.reject(fmt::format("column {} is {} (must be 0 where system.dimension = {})",
                               column + n + 1, number, dimension));
    }
  }
}

}  // namespace

XyzFrame read_last_frame(const std::filesystem::path& path, int dimension, std::int64_t spheres) {
  Lines lines(path);
  lines.go_back(last_frame(lines));
  const std::int64_t found = spheres_in(lines.required(), lines);
  if (found != spheres) {
    lines.reject(
        fmt::format("has {} spheres (system.spheres = {}); make them equal", found, spheres));
  }
  const std::string comment = lines.required();
  XyzFrame frame{.positions = {}, .velocities = {}, .sides = sides_in(comment, dimension, lines)};
  const Columns columns = columns_in(comment, dimension, lines);
  std::vector<std::string_view> words;
  for (std::int64_t i = 0; i < spheres; ++i) {
    words.clear();
    std::string_view rest = lines.required();
    for (auto word = next_word(rest); !word.empty(); word = next_word(rest)) words.push_back(word);
    append_numbers(words, columns.position, columns.position_count, dimension, frame.positions,
                   lines);
    append_numbers(words, columns.velocity, columns.velocity_count, dimension, frame.velocities,
                   lines);
  }
  return frame;
}

}  // namespace zenosphere
