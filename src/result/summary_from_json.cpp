#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>

#include "model/errors.hpp"
#include "result/summary.hpp"
#include "text/printable.hpp"

namespace zenosphere {

namespace {

using SortedJson = nlohmann::json;

[[noreturn]] void reject(const std::string& what) {
  constexpr std::size_t longest = 200;  // the library repeats what it could not read
  throw InputError("/zenosphere/summary: " + what.substr(0, longest) +
                   " (the file is damaged); run the case again");
}

/// Keeps its values in their types: the library would round a fraction to an integer, and a number
/// beyond the integers to nothing that is defined.
template <class T>
void read(const SortedJson& json, const char*, T& value) {
  if constexpr (std::is_same_v<T, std::int64_t>) {
    const bool fits = json.is_number_integer() &&
                      (!json.is_number_unsigned() ||
                       json.get<std::uint64_t>() <= std::numeric_limits<std::int64_t>::max());
    if (!fits) reject(fmt::format("a {} where an integer must be", json.type_name()));
  }
  value = json.get<T>();
}

/// Null stands for a number that is not finite.
void read(const SortedJson& json, const char*, double& value) {
  value = json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

void read(const SortedJson& values, const char* key, std::vector<double>& row) {
  for (const SortedJson& value : values) read(value, key, row.emplace_back());
}

void read(const SortedJson& json, const char* key, std::pair<std::int64_t, std::int64_t>& pair) {
  if (!json.is_array() || json.size() != 2) reject(fmt::format("{} has other than pairs", key));
  read(json[0], key, pair.first);
  read(json[1], key, pair.second);
}

/// A word of a table.
template <class Choice>
requires std::is_enum_v<Choice>
void read(const SortedJson& json, const char* key, Choice& value) {
  const auto text = json.get<std::string>();
  const auto choice = choice_in(words_of(Choice{}), text);
  if (choice) return void(value = *choice);
  std::string known;
  for (const auto& word : words_of(Choice{})) {
    known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", word.text);
  }
  reject(fmt::format("{} = \"{}\", which is none of {}", key, printable(shortened(text)), known));
}

template <HasFields Part>
void read(const SortedJson& json, const char*, Part& part);

/// Null stands for an absent value.
template <class T>
void read(const SortedJson& json, const char* key, std::optional<T>& value) {
  if (!json.is_null()) read(json, key, value.emplace());
}
/// No word stands for no end.
void read(const SortedJson& json, const char* key, std::optional<EndedBy>& value) {
  if (json != "") read(json, key, value.emplace());
}

template <class T>
void read(const SortedJson& json, const char* key, std::vector<T>& values) {
  if (!json.is_array()) reject(fmt::format("{} is no list", key));
  for (const SortedJson& value : json) read(value, key, values.emplace_back());
}

/// Where an object must have the field, or has it.
template <class T>
void read_field(const SortedJson& object, const Field& field, T& member) {
  if (field.may_lack && !object.contains(field.name)) return;
  read(object.at(field.name), field.name, member);
}

template <HasFields Part>
void read(const SortedJson& json, const char*, Part& part) {
  Part::fields(part, [&](const Field& field, auto& member) { read_field(json, field, member); });
}

void require_extents(const Observables& averages, int dimension) {
  const auto components = static_cast<std::size_t>(dimension);
  const std::size_t walls = averages.wall_pressure.size();
  const bool fits = averages.temperature_diagonal.size() == components &&
                    averages.pressure_tensor.size() == components * components &&
                    (walls == 0 || walls == 2) &&
                    (averages.wall_work.empty() || averages.wall_work.size() == walls);
  if (!fits) reject(fmt::format("its averages do not have {} dimensions", dimension));
}

void read_member(const SortedJson& json, const char* key, Shape, double& number) {
  read(json.at(key), key, number);
}
void read_member(const SortedJson& json, const char* key, Shape, std::optional<double>& number) {
  if (json.contains(key)) read(json.at(key), key, number.emplace());
}
/// A row that is missing is one of no numbers; `require_extents` looks at those that must be there.
void read_member(const SortedJson& json, const char* key, Shape shape,
                 std::vector<double>& numbers) {
  if (!json.contains(key)) return;
  if (shape == Shape::row) return read(json.at(key), key, numbers);
  for (const SortedJson& row : json.at(key)) read(row, key, numbers);
}

void read_observables(const SortedJson& json, int dimension, Observables& observables) {
  Observables::fields(observables, [&](const char* name, auto& member, Shape shape, Mean) {
    read_member(json, name, shape, member);
  });
  require_extents(observables, dimension);
}

std::optional<Averages> averages(const SortedJson& json, int dimension) {
  if (json.at("to_time").is_null()) return std::nullopt;
  Averages averages;
  read_observables(json, dimension, averages);
  Averages::remarks(averages,
                    [&](const Field& field, auto& member) { read_field(json, field, member); });
  if (!json.contains("standard_error")) return averages;  // of a version that had none
  const SortedJson& errors = json.at("standard_error");
  if (errors.at("pressure_tensor").is_null()) return averages;
  read_observables(errors, dimension, averages.standard_error.emplace());
  return averages;
}

Summary summary_of(const SortedJson& json, int dimension) {
  Summary summary;
  Summary::fields(summary, [&]<class T>(const Field& field, T& member) {
    if constexpr (std::is_same_v<T, std::optional<Averages>>) {
      member = averages(json.at(field.name), dimension);
    } else {
      read_field(json, field, member);
    }
  });
  return summary;
}

}  // namespace

Summary summary_from_json(const std::string& text, int dimension) {
  try {
    return summary_of(SortedJson::parse(text), dimension);
  } catch (const SortedJson::exception& error) {
    reject(error.what());
  }
}

}  // namespace zenosphere
