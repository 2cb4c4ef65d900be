#include "case/species_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "case/case_grains.hpp"
#include "model/grains.hpp"
#include "text/spelling.hpp"

namespace zenosphere::case_format {
namespace {

std::string label_of(const SpeciesContact& contact) {
  return contact.between[0] + '.' + contact.between[1];
}

/// Letters, digits, `_` and `-`: what an override and an extended XYZ file can name.
bool is_name(std::string_view text) {
  const auto is_bare = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
  return !text.empty() && text.size() <= 40 && std::all_of(text.begin(), text.end(), is_bare);
}

bool has_constants_for_all(const Case& values) {
  return values.collision.friction || values.collision.tangential_restitution;
}

}  // namespace

void SpeciesReader::reject(const Place& place, const std::string& text) {
  problems_.add(place, text);
  is_right_ = false;
}

/// Reports what was given for a path.
void SpeciesReader::blame(const std::string& path, const std::string& objection) {
  const Entry& entry = *given_.at(path);
  reject(entry.value_place, fmt::format("{} = {} {}", path, shown(entry.value), objection));
}

Species* SpeciesReader::species_named(std::string_view name) {
  const auto is_it = [&](const Species& species) { return species.name == name; };
  const auto found = std::find_if(values_.species.begin(), values_.species.end(), is_it);
  return found == values_.species.end() ? nullptr : &*found;
}

SpeciesContact* SpeciesReader::contact_of(std::string_view label) {
  const auto is_it = [&](const SpeciesContact& contact) { return label_of(contact) == label; };
  const auto found = std::find_if(values_.contacts.begin(), values_.contacts.end(), is_it);
  return found == values_.contacts.end() ? nullptr : &*found;
}

void SpeciesReader::read(const Entry& entry) {
  const std::size_t dot = entry.name.rfind('.');
  if (dot == std::string::npos) {
    return reject(entry.key_place, fmt::format("unknown key {} ({})", entry.key(),
                                               entry.table == "species"
                                                   ? "each kind has a table [[species]] with a name"
                                                   : "each pair of kinds has a table [[contact]]"));
  }
  const std::string label = entry.name.substr(0, dot);
  const std::string name = entry.name.substr(dot + 1);
  const bool is_species = entry.table == "species";
  if (name == (is_species ? "name" : "between")) return read_head(entry, label);
  if (is_species) return read_key(entry, name, species_named(label), species_keys());
  read_key(entry, name, contact_of(label), contact_keys());
}

void SpeciesReader::read_head(const Entry& entry, const std::string& label) {
  const bool is_species = entry.table == "species";
  const auto* text = std::get_if<std::string>(&entry.value);
  const std::size_t dot = text ? text->find('.') : std::string::npos;
  if (std::holds_alternative<TableHead>(entry.value)) {
    return reject(entry.key_place, is_species
                                       ? "missing key name of [[species]]; add name = \"...\""
                                       : "missing key between of [[contact]]; add between = "
                                         "[\"...\", \"...\"]");
  }
  if (entry.key_place.is_override()) {
    return reject(entry.key_place,
                  fmt::format("{} (is the name of a table); change it in the file", entry.key()));
  }
  const std::string path = entry.table + '.' + label;
  if (is_species) {
    if (!text || !is_name(*text)) {
      return reject(entry.value_place,
                    fmt::format("name = {} (must be letters, digits, _ and -, at most 40)",
                                shown(entry.value)));
    }
    if (species_named(*text)) {
      return reject(entry.value_place,
                    fmt::format("name = {} (another [[species]] has it)", shown(entry.value)));
    }
    if (values_.species.size() >= static_cast<std::size_t>(Grains<double>::most_kinds)) {
      return reject(entry.value_place,
                    fmt::format("more than {} tables [[species]]", Grains<double>::most_kinds));
    }
    values_.species.push_back({.name = *text});
  } else {
    if (dot == std::string::npos) {
      return reject(entry.value_place, fmt::format("between = {} (needs the names of two species)",
                                                   shown(entry.value)));
    }
    SpeciesContact contact{{text->substr(0, dot), text->substr(dot + 1)}};
    if (contact_of(label_of(contact)) ||
        contact_of(contact.between[1] + '.' + contact.between[0])) {
      return reject(entry.value_place, fmt::format("between = {} (another [[contact]] is of them)",
                                                   shown(entry.value)));
    }
    values_.contacts.push_back(std::move(contact));
  }
  given_.emplace(path, &entry);
}

/// \param item  null: there is none of this name
template <class Item>
void SpeciesReader::read_key(const Entry& entry, const std::string& name, Item* item,
                             std::span<const ItemKey<Item>> keys) {
  const std::string path = entry.table + '.' + entry.name;
  if (!item) {
    if (entry.key_place.is_override()) {
      reject(entry.key_place,
             fmt::format("unknown key {} (there is no such [[{}]])", path, entry.table));
    }
    return;  // its head was wrong, which was told
  }
  const auto is_it = [&](const auto& key) { return key.name == name; };
  const auto key = std::find_if(keys.begin(), keys.end(), is_it);
  if (key == keys.end()) {
    std::vector<std::string_view> names;
    for (const auto& other : keys) names.push_back(other.name);
    const auto meant = nearest(name, names);
    return reject(entry.key_place, fmt::format("unknown key {}", path) +
                                       (meant ? fmt::format("; did you mean {}?", *meant) : ""));
  }
  given_.emplace(path, &entry);
  if (const auto wrong = store(key->slot(*item), key->range, entry.value)) blame(path, *wrong);
}

void SpeciesReader::finish(bool knows_system) {
  check_species();
  if (is_right_ && knows_system && !values_.species.empty()) check_numbers();
  check_contacts();
}

void SpeciesReader::check_species() {
  bool has_mobile = values_.species.empty();
  for (const Species& species : values_.species) {
    const std::string path = "species." + species.name;
    const Place& place = given_.at(path)->value_place;
    has_mobile = has_mobile || !species.immobile;
    if (!is_given(path + ".diameter")) {
      reject(place, fmt::format("missing key {}.diameter (physics has no default)", path));
    }
    if (is_given(path + ".share") && is_given(path + ".spheres")) {
      blame(path + ".spheres", fmt::format("({}.share is given too); remove one of them", path));
      continue;
    }
    const bool has_one = is_given(path + ".share") || is_given(path + ".spheres");
    if (!has_one && values_.species.size() > 1) {
      reject(place,
             fmt::format("missing key {}.share or {}.spheres (how many there are)", path, path));
    }
    if (species.spheres.has_value() != values_.species.front().spheres.has_value()) {
      reject(place,
             fmt::format("species {} has {}, {} has not; give the same key for all", species.name,
                         species.spheres ? "spheres" : "a share", values_.species.front().name));
    }
  }
  if (!has_mobile) {
    blame("species." + values_.species.back().name + ".immobile",
          "(no sphere could move); let one kind move");
  }
}

/// Shares and numbers that add up, and a sphere of every kind.
void SpeciesReader::check_numbers() {
  const Species& last = values_.species.back();
  const std::string path = "species." + last.name;
  const std::int64_t spheres = values_.system.spheres;
  if (last.spheres) {
    std::int64_t sum = 0;
    for (const Species& species : values_.species) sum += *species.spheres;
    if (sum == spheres) return;
    return blame(path + ".spheres", fmt::format("(those of all species add up to {}, "
                                                "system.spheres = {}); make them equal",
                                                sum, spheres));
  }
  double sum = 0;
  for (const Species& species : values_.species) sum += species.share.value_or(1);
  constexpr double rounding = 1e-9;
  if (!(std::abs(sum - 1) <= rounding)) {
    return blame(path + ".share", fmt::format("(the shares add up to {:.9g}, must be 1)", sum));
  }
  const std::vector<std::int64_t> counts = spheres_by_species(values_);
  for (std::size_t kind = 0; kind < counts.size(); ++kind) {
    if (counts[kind] > 0) continue;
    blame(fmt::format("species.{}.share", values_.species[kind].name),
          fmt::format("(none of the {} spheres would be of it); use more spheres or a larger share",
                      spheres));
  }
}

void SpeciesReader::check_contacts() {
  for (const SpeciesContact& contact : values_.contacts) {
    const std::string path = "contact." + label_of(contact);
    for (const std::string& name : contact.between) {
      if (species_named(name)) continue;
      reject(given_.at(path)->value_place,
             fmt::format("[[contact]] between {} and {} (there is no "
                         "species {})",
                         contact.between[0], contact.between[1], name));
    }
    const bool has_any = is_given(path + ".restitution") ||
                         is_given(path + ".tangential_restitution") || is_given(path + ".friction");
    if (!has_any) {
      reject(given_.at(path)->value_place,
             fmt::format("[[contact]] between {} and {} (changes nothing); add restitution, or "
                         "remove it",
                         contact.between[0], contact.between[1]));
    }
    check_friction(contact);
  }
}

/// A rough contact has both, its own or those for all.
void SpeciesReader::check_friction(const SpeciesContact& contact) {
  if (has_constants_for_all(values_)) return;  // judged with the keys of [collision]
  const std::string path = "contact." + label_of(contact);
  if (contact.friction && !contact.tangential_restitution) {
    blame(path + ".friction", "(needs a tangential_restitution); add it");
  }
  if (contact.tangential_restitution && !contact.friction) {
    blame(path + ".tangential_restitution", "(needs a friction, maybe \"unbounded\"); add it");
  }
}

}  // namespace zenosphere::case_format
