#pragma once

#include <span>
#include <string_view>

#include "case/case_table.hpp"

namespace zenosphere::case_format {

/// One key of the tables [[species]] or [[contact]].
template <class Item>
struct ItemKey : CaseKey {
  std::size_t number;  ///< of them, from 0

  /// The member that it fills.
  Slot slot(Item& item) const {
    std::size_t passed = 0;
    Slot slot;
    item.keys([&](const CaseKey&, auto& member) {
      if (passed++ == number) slot = &member;
    });
    return slot;
  }
};

/// The keys of [[species]] beside its name, and of [[contact]] beside `between`, in the order of
/// the reference page.
std::span<const ItemKey<Species>> species_keys();
std::span<const ItemKey<SpeciesContact>> contact_keys();

/// The tables [[species]] and [[contact]] of a case as TOML writes them; empty where there are
/// none.
std::string species_toml(const Case& values);

}  // namespace zenosphere::case_format
