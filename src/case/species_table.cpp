#include "case/species_table.hpp"

#include <fmt/format.h>

#include <array>

#include "model/limits.hpp"

namespace zenosphere::case_format {
namespace {

// A diameter or mass that is so far from the others is meant in another unit.
constexpr Range positive{1e-6, 1e6, true, ""};
constexpr Range heavy{1e-30, 1e30, true, ""};

constexpr std::array species_key_table{
    ItemKey<Species>{"diameter", positive, [](Species& s) -> Slot { return &s.diameter; },
                     "of its spheres, in the mean of a distribution [length]"},
    ItemKey<Species>{"mass", heavy, [](Species& s) -> Slot { return &s.mass; },
                     "of a sphere of that diameter [mass]"},
    ItemKey<Species>{"share",
                     {0, 1, false, ""},
                     [](Species& s) -> Slot { return &s.share; },
                     "of the number of spheres"},
    ItemKey<Species>{"spheres",
                     {1, static_cast<double>(most_spheres), true, ""},
                     [](Species& s) -> Slot { return &s.spheres; },
                     "their number"},
    ItemKey<Species>{"immobile", positive, [](Species& s) -> Slot { return &s.immobile; },
                     "whether nothing moves them"},
};

constexpr std::array contact_key_table{
    ItemKey<SpeciesContact>{"restitution",
                            {0, 1, true, "1 is elastic"},
                            [](SpeciesContact& c) -> Slot { return &c.restitution; },
                            "normal speed after a collision / before"},
    ItemKey<SpeciesContact>{"tangential_restitution",
                            {-1, 1, true, "-1 is smooth"},
                            [](SpeciesContact& c) -> Slot { return &c.tangential_restitution; },
                            "- tangential speed of the surfaces after a sticking contact / before"},
    ItemKey<SpeciesContact>{"friction",
                            {0, 1e100, true, "or \"unbounded\""},
                            [](SpeciesContact& c) -> Slot { return &c.friction; },
                            "tangential impulse of a sliding contact / normal impulse"},
};

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

std::span<const ItemKey<Species>> species_keys() { return species_key_table; }
std::span<const ItemKey<SpeciesContact>> contact_keys() { return contact_key_table; }

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
