#include "start/xyz_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "start/start_file.hpp"
#include "text/spelling.hpp"

namespace zenosphere::xyz {
namespace {

constexpr std::size_t most_columns = 10'000;

/// The text up to the end of a value, which begins behind an opening quote or bracket.
std::size_t length_of_quoted(std::string_view text, char open) {
  int depth = 1;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (open == '"' && text[at] == '\\') {
      ++at;  // what follows does not end the text
    } else if (open == '"' ? text[at] == '"' : text[at] == (open == '[' ? ']' : '}')) {
      if (--depth == 0) return at;
    } else if (open != '"' && text[at] == open) {
      ++depth;
    }
  }
  return text.size();
}

/// Cuts `= value`, `="value"`, `=[value]` or `={value}` off a text; nothing where no `=` follows.
std::optional<std::string> next_value(std::string_view& text) {
  std::string_view rest = text;
  rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
  if (!rest.starts_with('=')) return std::nullopt;
  rest.remove_prefix(1);
  rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
  const char open = rest.empty() ? ' ' : rest.front();
  const bool is_closed = open == '"' || open == '[' || open == '{';
  if (is_closed) rest.remove_prefix(1);
  const std::size_t length =
      is_closed ? length_of_quoted(rest, open) : std::min(rest.find_first_of(blanks), rest.size());
  std::string value(rest.substr(0, length));
  rest.remove_prefix(std::min(length + (is_closed ? 1 : 0), rest.size()));
  text = rest;
  return value;
}

/// Calls `visit(key in small letters, value)` for what a line says, in its order.
template <class Visit>
void for_each_key(std::string_view line, Visit visit) {
  for (;;) {
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    if (line.empty()) return;
    const std::string name = lower_case(line.substr(0, line.find_first_of(" \t=")));
    line.remove_prefix(name.size());
    if (auto value = next_value(line)) visit(name, *std::move(value));
  }
}

/// The value of a key, or nothing. Throws where the line has it twice.
std::optional<std::string> value_of(std::string_view key, std::string_view line,
                                    const Lines& lines) {
  std::optional<std::string> found;
  for_each_key(line, [&](const std::string& name, std::string value) {
    if (name != key) return;
    if (found) lines.reject(fmt::format("has {} twice; keep one", key));
    found = std::move(value);
  });
  return found;
}

/// The words of a value; brackets and commas part them too.
std::vector<std::string> words_of(std::string value) {
  std::replace_if(
      value.begin(), value.end(),
      [](char c) { return std::string_view("[]{},").find(c) != std::string_view::npos; }, ' ');
  std::vector<std::string> words;
  std::string_view rest = value;
  for (auto word = next_word(rest); !word.empty(); word = next_word(rest)) words.emplace_back(word);
  return words;
}

Lattice lattice_in(std::string_view comment, int dimension, const Lines& lines) {
  const auto lattice = value_of("lattice", comment, lines);
  if (!lattice) {
    lines.reject(
        "has no Lattice (which box are the spheres in?); add Lattice=\"Lx 0 0 0 Ly 0 0 0 "
        "Lz\"");
  }
  const auto words = words_of(*lattice);
  if (words.size() != 9) {
    lines.reject(
        fmt::format("Lattice has {} numbers (must be 9, three vectors); write \"Lx 0 0 0 "
                    "Ly 0 0 0 Lz\"",
                    words.size()));
  }
  Lattice found;
  for (std::size_t n = 0; n < words.size(); ++n) {
    const double edge = finite_number(words[n], lines);
    const bool on_diagonal = n % 4 == 0;
    const bool is_offset = n == 3 && dimension > 1;
    if (is_offset) found.offset = edge;
    if (!on_diagonal && !is_offset && std::abs(edge) > touching) {
      lines.reject(
          fmt::format("Lattice has {} beside its diagonal (only the second vector may "
                      "lean, along x)",
                      edge));
    }
    if (on_diagonal && n / 4 < static_cast<std::size_t>(dimension)) found.sides.push_back(edge);
  }
  return found;
}

std::vector<double> origin_in(std::string_view comment, int dimension, const Lines& lines) {
  std::vector<double> origin(static_cast<std::size_t>(dimension));
  const auto written = value_of("origin", comment, lines);
  if (!written) return origin;
  const auto words = words_of(*written);
  if (words.size() != 3) {
    lines.reject(fmt::format("Origin has {} numbers (must be 3)", words.size()));
  }
  for (std::size_t axis = 0; axis < words.size(); ++axis) {
    const double corner = finite_number(words[axis], lines);
    if (axis < origin.size()) origin[axis] = corner;
  }
  return origin;
}

std::optional<std::array<bool, 3>> periodic_in(std::string_view comment, const Lines& lines) {
  const auto written = value_of("pbc", comment, lines);
  if (!written) return std::nullopt;
  const auto words = words_of(*written);
  if (words.size() != 3) lines.reject(fmt::format("pbc has {} words (must be 3)", words.size()));
  std::array<bool, 3> is_periodic{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string word = lower_case(words[axis]);
    is_periodic[axis] = word == "t" || word == "true" || word == "1";
    const bool is_word = is_periodic[axis] || word == "f" || word == "false" || word == "0";
    if (!is_word) lines.reject(fmt::format("pbc has {} (must be T or F)", shown(words[axis])));
  }
  return is_periodic;
}

/// Cuts the next part off `species:S:1:pos:R:3`.
std::string_view next_part(std::string_view& text) {
  const std::string_view part = text.substr(0, text.find(':'));
  text.remove_prefix(std::min(part.size() + 1, text.size()));
  return part;
}

template <std::size_t N>
bool is_one_of(const std::string& name, const std::array<std::string_view, N>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

constexpr std::array<std::string_view, 4> velocity_names{"velo", "vel", "velocity", "velocities"};
constexpr std::array<std::string_view, 2> momentum_names{"momenta", "momentum"};
constexpr std::array<std::string_view, 2> mass_names{"mass", "masses"};
constexpr std::array<std::string_view, 3> kind_columns{"kind", "type", "species"};
constexpr std::array<std::pair<std::string_view, double>, 6> fixed_names{{{"radius", 0.5},
                                                                          {"radii", 0.5},
                                                                          {"diameter", 1},
                                                                          {"diameters", 1},
                                                                          {"mass", 1},
                                                                          {"masses", 1}}};

/// Notes what the columns of one name are. Throws where another name has told it already.
void note_columns(const std::string& name, Columns::Span span, Columns& columns,
                  const Lines& lines) {
  const bool is_momentum = is_one_of(name, momentum_names);
  if (name == "pos") {
    if (columns.position.count > 0) lines.reject("Properties has pos twice; keep one");
    columns.position = span;
  } else if (is_momentum || is_one_of(name, velocity_names)) {
    Columns::Span& found = is_momentum ? columns.momentum : columns.velocity;
    if (found.count > 0) {
      lines.reject(fmt::format("Properties has {} and {} (which are the velocities?); keep one",
                               is_momentum ? "momenta" : columns.velocity_name, name));
    }
    found = span;
    if (!is_momentum) columns.velocity_name = name;
  }
  const auto kind = std::find(kind_columns.begin(), kind_columns.end(), name);
  const auto rank = static_cast<std::size_t>(kind - kind_columns.begin());
  if (kind != kind_columns.end() && !(columns.kind && columns.kind->rank <= rank)) {
    columns.kind = {rank, span.first};
  }
  if (name == "angular_velocity" && span.count == 3) columns.spin = span;
  columns.has_masses = columns.has_masses || is_one_of(name, mass_names);
  for (const auto& [fixed, value] : fixed_names) {
    if (fixed == name) columns.fixed.push_back({name, span.first, value});
  }
}

/// Momenta are the velocities where there are no others.
void choose_velocities(Columns& columns) {
  columns.has_momenta = columns.velocity.count == 0 && columns.momentum.count > 0;
  if (!columns.has_momenta) return;
  columns.velocity = std::exchange(columns.momentum, {});
  columns.velocity_name = "momenta";
}

void require_fitting(const Columns& columns, int dimension, const Lines& lines) {
  const auto fits = [&](std::size_t count) {
    return count >= static_cast<std::size_t>(dimension) && count <= 3;
  };
  if (!fits(columns.position.count)) lines.reject("Properties has no pos:R:3; add the positions");
  if (columns.velocity.count > 0 && !fits(columns.velocity.count)) {
    lines.reject(fmt::format("Properties has {} of {} columns (must be {}:R:3)",
                             columns.velocity_name, columns.velocity.count, columns.velocity_name));
  }
  if (columns.momentum.count > 0 && columns.momentum.count != columns.velocity.count) {
    lines.reject(fmt::format("Properties has momenta of {} columns (must be {}, as of {})",
                             columns.momentum.count, columns.velocity.count,
                             columns.velocity_name));
  }
}

Columns columns_in(std::string_view comment, int dimension, const Lines& lines) {
  const auto properties = value_of("properties", comment, lines);
  if (!properties) {
    Columns plain;
    plain.position = {.first = 1, .count = 3};
    return plain;
  }
  Columns columns;
  std::string_view rest = *properties;
  std::size_t column = 0;
  while (!rest.empty()) {
    const std::string name = lower_case(next_part(rest));
    next_part(rest);  // the type: what is read must be a number anyway
    const std::string_view written = next_part(rest);
    const auto count = number_in<std::size_t>(written);
    if (!count || *count < 1 || *count > most_columns || column > most_columns) {
      lines.reject(fmt::format("Properties: column {} has the count {} (must be in [1, {}])",
                               shown(name), shown(written), most_columns));
    }
    note_columns(name, {.first = column, .count = *count}, columns, lines);
    column += *count;
  }
  columns.total = column;
  choose_velocities(columns);
  require_fitting(columns, dimension, lines);
  return columns;
}

/// Whether one letter makes a name that of a key which is read, long enough to be meant.
const char* misspelt(const std::string& name) {
  for (const char* key : {"Lattice", "Origin", "Properties"}) {
    if (edit_distance(name, lower_case(key)) == 1) return key;
  }
  return nullptr;
}

/// Nothing that a frame says of all its spheres is passed over: it agrees with those of a case, or
/// is refused.
void require_agreement(std::string_view comment, Columns& columns, const Lines& lines) {
  for_each_key(comment, [&](const std::string& name, const std::string& value) {
    for (const auto& [fixed, expected] : fixed_names) {
      if (fixed == name) require_unit(name, finite_number(value, lines), expected, lines);
    }
    columns.has_masses = columns.has_masses || is_one_of(name, mass_names);
    if (name == "pos" || is_one_of(name, velocity_names) || is_one_of(name, momentum_names)) {
      lines.reject(
          fmt::format("has {} for all spheres (needs columns); name them in Properties", name));
    }
    if (const char* key = misspelt(name)) {
      lines.reject(fmt::format("has an unknown key {}; did you mean {}?", shown(name), key));
    }
  });
}

}  // namespace

void require_unit(const std::string& name, double number, double expected, const Lines& lines) {
  if (std::abs(number - expected) <= file_accuracy) return;
  lines.reject(
      fmt::format("{} = {} (spheres have {}: diameter and mass are the units); give the file in "
                  "them",
                  name, number, expected));
}

Header header_of(std::string_view comment, int dimension, const Lines& lines) {
  Header header{.lattice = lattice_in(comment, dimension, lines),
                .origin = origin_in(comment, dimension, lines),
                .is_periodic = periodic_in(comment, lines),
                .columns = columns_in(comment, dimension, lines)};
  if (const auto names = value_of("kinds", comment, lines)) header.kind_names = words_of(*names);
  require_agreement(comment, header.columns, lines);
  return header;
}

}  // namespace zenosphere::xyz
