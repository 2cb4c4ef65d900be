#pragma once

#include <cstdint>
#include <span>

#include "model/grains.hpp"
#include "model/shear_box.hpp"

namespace zenosphere {

/// How far and for how long a sphere may go until its neighbour list is rebuilt.
struct ListRange {
  double grain;        ///< unit of places within cells, diameters
  double reach;        ///< from its reference position, diameters
  double distance;     ///< of reference positions, diameters: spheres further apart cannot touch
  int lists_a_cell;    ///< while layers slide by a cell, so many lists are needed one by one
  double window;       ///< time; infinite without shear
  double expiry_unit;  ///< of ReferencePosition::expires, time: a power of two about as long as the
                       ///< clock unit
  double neighbours;   ///< on a list, where the spheres are spread evenly
  bool is_wide;    ///< as wide as the cells, while no sphere has more neighbours than most_alone
  bool is_dilute;  ///< many spheres, most of which fly through their balls and meet no other there
};

/// How large spheres are, as far as cells and lists have to know.
struct Sizes {
  double largest = 1;  ///< diameter
  double mean = 1;
};

template <class Real>
Sizes sizes_of(const Grains<Real>& grains) {
  if (grains.diameters.empty()) return {};
  double sum = 0;
  for (const Real& diameter : grains.diameters) sum += static_cast<double>(diameter);
  return {static_cast<double>(grains.largest_diameter()),
          sum / static_cast<double>(grains.diameters.size())};
}

/// Spheres on one list, where balls are as wide as cells: with more of them they are a crowd.
inline constexpr std::int32_t most_alone = 400;

/// Spheres that are new to one that crosses a face of its cell, of a third of the cells around:
/// where there are more they are a crowd. In a gas there are some five.
inline constexpr std::int32_t most_beyond_face = 40;

/// What suits so many spheres in a box that is cut into cells. Two spheres that may touch have
/// reference positions within the largest diameter + 2 reach, which no cell may be narrower than.
template <int Dim, class Real>
ListRange list_range_in(const ShearBox<Dim, Real>& box, std::int32_t spheres,
                        const Sizes& sizes = {});

/// The same where they crowd together somewhere, however much room there is elsewhere.
template <int Dim, class Real>
ListRange list_range_in_crowd(const ShearBox<Dim, Real>& box, std::int32_t spheres,
                              const Sizes& sizes = {});

/// A box and what is in it.
struct Filling {
  std::span<const double> sides;  ///< diameters
  std::int64_t spheres;
  Sizes sizes{};
  bool is_straight = true;  ///< spheres do not fall
};

/// The width that cells should have, in diameters: so that some fifteen neighbours are in reach; in
/// dilute systems, in which there are no lists (see CellSearch), so that a cell holds about one.
///
/// Wider cells mean longer lists that last longer. Where spheres differ in size, the largest have
/// to find room in a cell.
double fitting_cell_width(const Filling& filling);

/// Whether spheres that fly straight are looked for cell by cell, without lists: they are dilute,
/// and the box is cut into many narrow cells.
template <int Dim, class Real>
bool cells_suffice(const ShearBox<Dim, Real>& box, std::int32_t spheres, const Sizes& sizes);

}  // namespace zenosphere
