#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "case/case.hpp"
#include "case/case_entries.hpp"
#include "case/case_problems.hpp"
#include "case/species_table.hpp"

namespace zenosphere::case_format {

/// Reads the tables [[species]] and [[contact]] of a case.
class SpeciesReader {
 public:
  /// \param values    gets species and contacts
  /// \param problems  gets what is wrong with one of them
  SpeciesReader(Case& values, Problems& problems) : values_(values), problems_(problems) {}

  static bool reads(std::string_view table) { return table == "species" || table == "contact"; }

  /// Takes an entry of one of the two tables, the one that names an item before its others.
  void read(const Entry& entry);

  /// Checks what every item must have, and how they go together.
  ///
  /// \param knows_system  whether dimension and number of spheres are right
  void finish(bool knows_system);

  /// Whether nothing was wrong.
  bool is_right() const { return is_right_; }

 private:
  void read_head(const Entry& entry, const std::string& label);
  template <class Item>
  void read_key(const Entry& entry, const std::string& name, Item* item,
                std::span<const ItemKey<Item>> keys);
  Species* species_named(std::string_view name);
  SpeciesContact* contact_of(std::string_view label);
  void check_species();
  void check_numbers();
  void check_contacts();
  void check_friction(const SpeciesContact& contact);
  void reject(const Place& place, const std::string& text);
  void blame(const std::string& path, const std::string& objection);
  bool is_given(const std::string& path) const { return given_.contains(path); }

  Case& values_;
  Problems& problems_;
  bool is_right_ = true;
  std::map<std::string, const Entry*, std::less<>> given_;  ///< by path
};

}  // namespace zenosphere::case_format
