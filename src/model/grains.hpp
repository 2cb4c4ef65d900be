#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/archive.hpp"

namespace zenosphere {

/// What each sphere is, where they are not all unit spheres of one kind.
///
/// An empty vector says the same of all: diameter 1, mass 1, kind 0, mobile. One that is not empty
/// has an entry for each sphere. A start of unit spheres leaves all four empty, which costs
/// nothing.
template <class Real>
struct Grains {
  std::vector<Real> diameters{};         ///< > 0, in units of length
  std::vector<Real> masses{};            ///< > 0, in units of mass
  std::vector<std::int32_t> kinds{};     ///< rows of the ContactTable, >= 0
  std::vector<std::uint8_t> immobile{};  ///< 1: keeps its velocity whatever hits it, and no force
                                         ///< or kick moves it; its mass is infinite

  /// Whether all are unit spheres of one kind.
  bool are_alike() const {
    return diameters.empty() && masses.empty() && kinds.empty() && immobile.empty();
  }

  Real diameter(std::int32_t i) const { return diameters.empty() ? Real(1) : diameters[at(i)]; }
  Real radius(std::int32_t i) const { return diameter(i) / 2; }
  /// Of an immobile sphere the one that it would have if it could move.
  Real mass(std::int32_t i) const { return masses.empty() ? Real(1) : masses[at(i)]; }
  std::int32_t kind(std::int32_t i) const { return kinds.empty() ? 0 : kinds[at(i)]; }
  bool is_immobile(std::int32_t i) const { return !immobile.empty() && immobile[at(i)] != 0; }

  /// 1 / mass; 0 of an immobile sphere.
  Real inverse_mass(std::int32_t i) const {
    if (is_immobile(i)) return 0;
    return masses.empty() ? Real(1) : Real(1 / masses[at(i)]);
  }

  Real largest_diameter() const {
    return diameters.empty() ? Real(1) : *std::max_element(diameters.begin(), diameters.end());
  }
  std::int32_t kind_count() const {
    return kinds.empty() ? 1 : 1 + *std::max_element(kinds.begin(), kinds.end());
  }

  /// \throws ArchiveError for spheres that there cannot be
  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.diameters, self.masses, self.kinds, self.immobile);
    using std::isfinite;
    for (const auto* const sizes : {&self.diameters, &self.masses}) {
      for (const Real& size : *sizes) {
        require_archived(isfinite(size) && size > 0, "a sphere without size or mass");
      }
    }
    for (const std::int32_t kind : self.kinds) {
      require_archived(kind >= 0 && kind < most_kinds, "a kind that there is not");
    }
    for (const std::uint8_t one : self.immobile) {
      require_archived(one <= 1, "a sphere that neither moves nor rests");
    }
  }

  /// Throws ArchiveError unless there is an entry for each of so many spheres, or none.
  void require_fit(std::size_t spheres) const {
    for (const std::size_t size :
         {diameters.size(), masses.size(), kinds.size(), immobile.size()}) {
      require_archived(size == 0 || size == spheres, "grains of another number of spheres");
    }
  }

  static constexpr std::int32_t most_kinds = 256;

 private:
  static std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }
};

}  // namespace zenosphere
