#include <fmt/format.h>

#include <array>
#include <limits>
#include <nlohmann/json.hpp>

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
T value_of(const SortedJson& member) {
  if constexpr (std::is_same_v<T, std::int64_t>) {
    const bool fits = member.is_number_integer() &&
                      (!member.is_number_unsigned() ||
                       member.get<std::uint64_t>() <= std::numeric_limits<std::int64_t>::max());
    if (!fits) reject(fmt::format("a {} where an integer must be", member.type_name()));
  }
  return member.get<T>();
}

template <class T>
void read(const SortedJson& object, const char* key, T& value) {
  value = value_of<T>(object.at(key));
}

/// Null stands for an absent value.
template <class T>
void read(const SortedJson& object, const char* key, std::optional<T>& value) {
  const SortedJson& member = object.at(key);
  if (!member.is_null()) value = value_of<T>(member);
}

/// Null stands for a number that is not finite.
void read(const SortedJson& object, const char* key, double& value) {
  const SortedJson& member = object.at(key);
  value = member.is_null() ? std::numeric_limits<double>::quiet_NaN() : member.get<double>();
}

void read(const SortedJson& values, std::vector<double>& row) {
  for (const SortedJson& value : values) {
    row.push_back(value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>());
  }
}

/// Reads a word of a table.
template <class Choice, std::size_t N>
Choice read_word(const SortedJson& object, const char* key,
                 const std::array<Word<Choice>, N>& table) {
  const auto text = object.at(key).get<std::string>();
  const auto choice = choice_in(table, text);
  if (choice) return *choice;
  std::string known;
  for (const auto& word : table) {
    known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", word.text);
  }
  reject(fmt::format("{} = \"{}\", which is none of {}", key, printable(shortened(text)), known));
}

std::optional<EndedBy> read_ended_by(const SortedJson& json) {
  const char* const key = "ended_by";
  if (json.at(key) == "") return std::nullopt;
  return read_word(json, key, ended_by_words);
}

void read_pairs(const SortedJson& json, Summary::Arrest& arrest) {
  for (const SortedJson& pair : json) {
    if (!pair.is_array() || pair.size() != 2) reject("arrest.pairs has other than pairs");
    arrest.pairs.emplace_back(value_of<std::int64_t>(pair[0]), value_of<std::int64_t>(pair[1]));
  }
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
  read(json, key, number);
}
void read_member(const SortedJson& json, const char* key, Shape, std::optional<double>& number) {
  if (json.contains(key)) read(json, key, number.emplace());
}
/// A row that is missing is one of no numbers; `require_extents` looks at those that must be there.
void read_member(const SortedJson& json, const char* key, Shape shape,
                 std::vector<double>& numbers) {
  if (!json.contains(key)) return;
  if (shape == Shape::row) return read(json.at(key), numbers);
  for (const SortedJson& row : json.at(key)) read(row, numbers);
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
  read(json, "from_time", averages.from_time);
  read(json, "to_time", averages.to_time);
  if (!json.contains("standard_error")) return averages;  // of a version that had none
  read(json, "blocks", averages.blocks);
  read(json, "steady", averages.steady);
  read(json, "steady_reason", averages.steady_reason);
  read(json, "streak_amplitude", averages.streak_amplitude);
  read(json, "temperature_without_streak", averages.temperature_without_streak);
  const SortedJson& errors = json.at("standard_error");
  if (errors.at("pressure_tensor").is_null()) return averages;
  read_observables(errors, dimension, averages.standard_error.emplace());
  return averages;
}

void read_collapse(const SortedJson& json, Summary& summary) {
  summary.verdict = read_word(json, "verdict", verdict_words);
  const SortedJson& separation = json.at("separation");
  read(separation, "hits", summary.separation.hits);
  read(separation, "first_collision", summary.separation.first_collision);
  read(separation, "first_time", summary.separation.first_time);
  read(separation, "last_collision", summary.separation.last_collision);
  if (separation.contains("last_time")) {
    read(separation, "last_time", summary.separation.last_time);
    read(separation, "longest_pause", summary.separation.longest_pause);
  }
  const SortedJson& arrest = json.at("arrest");
  read(arrest, "met", summary.arrest.met);
  read(arrest, "collision", summary.arrest.collision);
  read(arrest, "time", summary.arrest.time);
  read(arrest, "window", summary.arrest.window);
  read_pairs(arrest.at("pairs"), summary.arrest);
  read(arrest, "extrapolated_time", summary.arrest.extrapolated_time);
  read(arrest, "flight_ratio", summary.arrest.flight_ratio);
  if (arrest.contains("others_moving")) {
    read(arrest, "others_moving", summary.arrest.others_moving);
  }
}

std::optional<Summary::Dissected> dissected(const SortedJson& json) {
  if (json.is_null()) return std::nullopt;
  Summary::Dissected dissected;
  read(json, "collision", dissected.collision);
  read(json, "time", dissected.time);
  read(json, "clusters", dissected.clusters);
  read(json, "spheres", dissected.spheres);
  read(json, "contacts", dissected.contacts);
  read(json, "chain", dissected.chain);
  read(json, "straightness", dissected.straightness);
  read(json, "cycle", dissected.cycle);
  read(json, "gap_ratio", dissected.gap_ratio);
  read(json, "speed_ratio", dissected.speed_ratio);
  read(json, "flight_ratio", dissected.flight_ratio);
  read(json, "exact_gap_ratio", dissected.exact_gap_ratio);
  read(json, "exact_speed_ratio", dissected.exact_speed_ratio);
  read(json, "exact_flight_ratio", dissected.exact_flight_ratio);
  read(json, "collapse_time", dissected.collapse_time);
  read(json, "collapse_time_error", dissected.collapse_time_error);
  return dissected;
}

/// Absent from files of version 0.1.0 that were written before there were contact models.
void read_contact(const SortedJson& json, Summary::Contact& contact) {
  read(json, "mean_restitution", contact.mean_restitution);
  read(json, "made_elastic", contact.made_elastic);
  read(json, "rotated", contact.rotated);
}

void read_species(const SortedJson& json, Summary& summary) {
  for (const SortedJson& row : json) {
    Summary::Kind kind;
    read(row, "name", kind.name);
    read(row, "spheres", kind.spheres);
    read(row, "granular_temperature", kind.granular_temperature);
    read(row, "rotational_temperature", kind.rotational_temperature);
    summary.species.push_back(std::move(kind));
  }
}

Summary summary_of(const SortedJson& json, int dimension) {
  Summary summary;
  read(json, "collisions", summary.collisions);
  read(json, "collisions_per_sphere", summary.collisions_per_sphere);
  read(json, "time", summary.time);
  read(json, "strain", summary.strain);
  summary.outcome = read_word(json, "outcome", outcome_words);
  read_collapse(json, summary);
  read(json, "absorbed", summary.absorbed);
  summary.averages = averages(json.at("averages"), dimension);
  if (json.contains("species")) read_species(json.at("species"), summary);
  read(json, "ledger_error", summary.ledger_error);
  read(json, "wall_seconds", summary.wall_seconds);
  read(json, "collisions_per_second", summary.collisions_per_second);
  read(json, "peak_memory_bytes", summary.peak_memory_bytes);
  summary.ended_by = read_ended_by(json);
  read(json, "overlap_collisions", summary.overlap_collisions);
  read(json, "overlaps_ignored", summary.overlaps_ignored);
  read(json, "receding", summary.receding);
  if (json.contains("anatomy")) {
    summary.anatomy = {dissected(json.at("anatomy").at("hit")),
                       dissected(json.at("anatomy").at("arrest"))};
  }
  if (json.contains("contact")) read_contact(json.at("contact"), summary.contact);
  if (json.contains("self_check")) read(json, "self_check", summary.self_check);
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
