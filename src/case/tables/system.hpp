#pragma once

#include <cstdint>
#include <vector>

#include "case/tables/collision.hpp"
#include "model/case_key.hpp"
#include "model/limits.hpp"

namespace zenosphere {

/// Longest side of a box, and farthest place [diameters]: a coordinate at the far end is still good
/// to a millionth of a diameter.
inline constexpr double largest_side = 1e9;

/// What the rules about the box need to know of the diameters of all spheres.
struct SizeSummary {
  double mean = 1;        ///< diameter
  double mean_power = 1;  ///< mean of diameter^D
  double smallest = 1;
  double largest = 1;
};

namespace case_format {

inline constexpr When only_without_sides{"system.sides", "",
                                         [](const auto& c) { return c.system.sides.empty(); },
                                         "a box without system.sides"};
inline constexpr When only_in_a_proportion{
    "system.dimension", "system.sides",
    [](const auto& c) { return c.system.dimension > 1 && c.system.sides.empty(); },
    "two or three dimensions, without system.sides"};
inline constexpr When only_constant{
    "collision.restitution_law", "",
    [](const auto& c) { return c.collision.restitution_law == RestitutionLaw::constant; },
    "collision.restitution_law = \"constant\""};

/// The table [system]: the spheres and their box.
struct System {
  int dimension = 0;
  std::int64_t spheres = 0;
  double restitution = 0;             ///< read by RestitutionLaw::constant only
  double solids_volume_fraction = 0;  ///< of the box; 0 where `sides` are given
  double aspect_ratio = 1;            ///< side along x / each other side
  std::vector<double> sides{};        ///< D sides; empty: from the two keys above
  SizeSummary sizes{};                ///< no key: what follows from species and their spread

  template <class Visitor>
  void keys(Visitor&& visit) {
    visit(CaseKey{"dimension", required, from_to(1, 3), "dimensions of space"}, dimension);
    visit(CaseKey{"spheres", required, from_to(1, static_cast<double>(most_spheres)),
                  "number of spheres"},
          spheres);
    visit(CaseKey{"restitution", required, from_to(0, 1, "1 is elastic"),
                  "normal speed after a collision / before"},
          restitution, only_constant);
    visit(CaseKey{"solids_volume_fraction", optional, above_to(0, 1),
                  "volume of the spheres / volume of the box"},
          solids_volume_fraction, only_without_sides);
    visit(CaseKey{"sides", optional, above_to(1, largest_side), "of the box [diameters]"}, sides);
    visit(CaseKey{"aspect_ratio", optional, above_to(0.01, 100, "for others give system.sides"),
                  "side of the box along x / each other side"},
          aspect_ratio, only_in_a_proportion);
  }
};

}  // namespace case_format
}  // namespace zenosphere
