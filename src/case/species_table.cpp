#include "case/species_table.hpp"

#include <fmt/format.h>

#include <vector>

namespace zenosphere::case_format {
namespace {

template <class Item>
std::vector<ItemKey<Item>> all_keys_of() {
  std::vector<ItemKey<Item>> keys;
  Item().keys([&](const CaseKey& key, const auto&) { keys.push_back({key, keys.size()}); });
  return keys;
}

template <class Item>
std::string lines_of(Item item, std::span<const ItemKey<Item>> keys) {
  std::string text;
  for (const auto& key : keys) {
    const auto value = toml_text(key.slot(item));
    if (value) text += fmt::format("{} = {}  # {}\n", key.name, *value, key.meaning);
  }
  return text;
}

}  // namespace

std::span<const ItemKey<Species>> species_keys() {
  static const auto keys = all_keys_of<Species>();
  return keys;
}
std::span<const ItemKey<SpeciesContact>> contact_keys() {
  static const auto keys = all_keys_of<SpeciesContact>();
  return keys;
}

std::string species_toml(const Case& values) {
  std::string text;
  for (const Species& species : values.species) {
    text += fmt::format("\n[[species]]\nname = {}\n{}", in_quotes(species.name),
                        lines_of(species, species_keys()));
  }
  for (const SpeciesContact& contact : values.contacts) {
    text += fmt::format("\n[[contact]]\nbetween = [{}, {}]\n{}", in_quotes(contact.between[0]),
                        in_quotes(contact.between[1]), lines_of(contact, contact_keys()));
  }
  return text;
}

}  // namespace zenosphere::case_format
