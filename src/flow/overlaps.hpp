#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/overlap_rule.hpp"

namespace zenosphere {

/// A state as a snapshot has it: laboratory positions in a box whose images along y are displaced.
struct PlacedSpheres {
  std::vector<double> positions;    ///< N x D, row-major, diameters, each component in [0, L]
  std::vector<double> sides;        ///< D, each > 2 largest diameters, along a closed axis > 1
  double offset = 0;                ///< of the upper image of the box along x, diameters
  std::optional<int> closed{};      ///< the axis between walls, if there is one
  std::vector<double> diameters{};  ///< N; empty: all 1
  std::vector<std::uint8_t>
      immobile{};  ///< N; empty: none. Two that are may overlap from the start
};

/// Two spheres and how deep they are in each other, diameters; negative: their gap.
struct Overlap {
  std::int64_t i = -1;
  std::int64_t j = -1;  ///< > i
  double depth = -1;
};

/// The deepest overlap of a state; `depth` <= 0 where no two spheres overlap, and then i and j mean
/// nothing.
///
/// Sorts the spheres by cells of its own, and shares nothing with the engine: a pair that the
/// engine has lost sight of is found here. Depths are good to some ulps of a side.
Overlap deepest_overlap(const PlacedSpheres& spheres);

/// What an overlap rule promises: no two spheres are deeper in each other than this, diameters.
///
/// `guarded` lets spheres pass that approach with less than its guard: they sink in by that much in
/// a time unit at most. `rewind` may set each of two spheres back by longest_way_back(), into a
/// third one.
///
/// \param guard         diameters^2/time, and the time since the start, in the case's unit
/// \param longest_side  of the box, diameters
/// \param largest       diameter
double deepest_permitted(OverlapRule rule, double guard, double time, double longest_side,
                         double largest = 1);

}  // namespace zenosphere
