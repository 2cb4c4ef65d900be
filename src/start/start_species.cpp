#include "start/start_species.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "case/case_file.hpp"
#include "case/case_grains.hpp"
#include "model/errors.hpp"
#include "model/grains.hpp"
#include "start/extended_xyz.hpp"
#include "storage/output_info.hpp"

namespace zenosphere {
namespace {

/// Spheres of a file that follow one another and agree.
struct Group {
  std::string word;
  double diameter = 1;
  std::optional<double> mass{};  ///< none: not told
  std::int64_t first = 0;        ///< number of the sphere
  std::int64_t spheres = 0;

  bool is_like(const Group& other) const {
    return word == other.word && diameter == other.diameter && mass == other.mass;
  }
  bool are_unit_spheres() const {
    constexpr double equal = 1e-9;  // files in text often have ten digits
    return std::abs(diameter - 1) <= equal && std::abs(mass.value_or(1) - 1) <= equal;
  }
};

Group sphere_of(const XyzFrame& frame, std::size_t i) {
  Group one;
  one.first = static_cast<std::int64_t>(i);
  one.spheres = 1;
  if (!frame.kinds.empty()) one.word = frame.kinds[i];
  if (!frame.diameters.empty()) one.diameter = frame.diameters[i];
  if (!frame.masses.empty()) one.mass = frame.masses[i];
  return one;
}

void add(const Group& sphere, std::vector<Group>& groups, const std::string& file) {
  if (!groups.empty() && groups.back().is_like(sphere)) {
    ++groups.back().spheres;
    return;
  }
  const auto is_it = [&](const Group& group) { return group.is_like(sphere); };
  const auto earlier = std::find_if(groups.begin(), groups.end(), is_it);
  if (earlier != groups.end()) {
    throw InputError(
        fmt::format("{}: sphere {} is like sphere {}, and others are between them (spheres of a "
                    "kind follow one "
                    "another); sort the file by kind",
                    file, sphere.first, earlier->first));
  }
  if (groups.size() == static_cast<std::size_t>(Grains<double>::most_kinds)) {
    throw InputError(fmt::format(
        "{}: has more than {} kinds of spheres (by diameter and mass); describe them in the case, "
        "with [polydispersity]",
        file, Grains<double>::most_kinds));
  }
  groups.push_back(sphere);
}

std::vector<Group> groups_in(const Case& values) {
  const XyzFrame frame = read_frame(values.start.file, values.system.dimension,
                                    values.system.spheres, values.start.snapshot);
  std::vector<Group> groups;
  const auto spheres = static_cast<std::size_t>(values.system.spheres);
  for (std::size_t i = 0; i < spheres; ++i) add(sphere_of(frame, i), groups, values.start.file);
  return groups;
}

/// The word of a group where a species can have it and no other group has; else its number.
std::string name_of(const std::vector<Group>& groups, std::size_t n) {
  const std::string& word = groups[n].word;
  const auto is_bare = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
  const auto has_it = [&](const Group& group) { return group.word == word; };
  constexpr std::size_t longest = 40;
  const bool is_name = !word.empty() && word.size() <= longest &&
                       std::all_of(word.begin(), word.end(), is_bare) &&
                       std::count_if(groups.begin(), groups.end(), has_it) == 1;
  return is_name ? word : fmt::format("kind{}", n + 1);
}

std::vector<Species> species_in_text(const Case& values) {
  const std::vector<Group> groups = groups_in(values);
  const auto is_unit = [](const Group& group) { return group.are_unit_spheres(); };
  if (std::all_of(groups.begin(), groups.end(), is_unit)) return {};
  std::vector<Species> species;
  for (std::size_t n = 0; n < groups.size(); ++n) {
    species.push_back({.name = name_of(groups, n),
                       .diameter = groups[n].diameter,
                       .mass = groups[n].mass,
                       .spheres = groups[n].spheres});
  }
  return species;
}

/// Those of the case of an output file; drawn diameters follow from another seed.
std::vector<Species> species_in_output(const std::string& file) {
  const Case written = parse_case(read_output_info(file).resolved_case, file, {});
  if (written.species.empty() || written.polydispersity.distribution) return {};
  const std::vector<std::int64_t> counts = spheres_by_species(written);
  std::vector<Species> species = written.species;
  for (std::size_t n = 0; n < species.size(); ++n) {
    species[n].share.reset();
    species[n].spheres = counts[n];
  }
  return species;
}

}  // namespace

std::mutex& one_start_at_a_time() {
  static std::mutex mutex;
  return mutex;
}

Case with_species_of_start(Case values) {
  const bool says_it = !values.species.empty() || values.polydispersity.distribution;
  if (values.start.arrangement != Arrangement::file || says_it) return values;
  const std::string& file = values.start.file;
  {
    const std::lock_guard lock(one_start_at_a_time());
    values.species = is_hdf5_file(file) ? species_in_output(file) : species_in_text(values);
  }
  if (values.species.empty()) return values;
  Case checked = parse_written_case(resolved_toml(values), file, {});
  checked.text = std::move(values.text);
  return checked;
}

void require_equal_kinds(const std::vector<std::string>& kinds, const Case& values,
                         const std::string& where) {
  const auto& species = values.species;
  const auto is_named = [&](const std::string& kind) {
    const auto is_it = [&](const Species& one) { return one.name == kind; };
    return std::any_of(species.begin(), species.end(), is_it);
  };
  if (species.empty() || !std::all_of(kinds.begin(), kinds.end(), is_named)) return;
  const Grains<double> grains = grains_of(values);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const auto kind = static_cast<std::size_t>(grains.kind(static_cast<std::int32_t>(i)));
    if (kinds[i] == species[kind].name) continue;
    throw InputError(
        fmt::format("{}: sphere {} is of the kind {} (in the case it is {}); list the "
                    "spheres in the order of the species",
                    where, i, kinds[i], species[kind].name));
  }
}

}  // namespace zenosphere
