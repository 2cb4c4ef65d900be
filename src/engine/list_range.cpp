#include "engine/list_range.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>

#include "engine/cell_search.hpp"
#include "engine/reference_cells.hpp"
#include "model/instantiate.hpp"
#include "model/power.hpp"

namespace zenosphere {

namespace {

/// How far a sphere flies between two collisions in a thin gas, diameters.
///
/// \param share  volume for each sphere, diameters^dimension
/// Source: Chapman & Cowling, The Mathematical Theory of Non-Uniform Gases (1970), sec. 5.21.
double mean_free_path(double share, int dimension) {
  constexpr std::array<double, 3> cross_sections{1, 2, std::numbers::pi};
  return share / (std::numbers::sqrt2 * cross_sections[static_cast<std::size_t>(dimension - 1)]);
}

/// How far apart reference positions on one list may be, diameters. Where the spheres of a dilute
/// system crowd together the lists have to hold them: some 400 that are packed closely.
double most_width(int dimension) {
  constexpr std::array<double, 3> most{100, 9, 4};
  return most[static_cast<std::size_t>(dimension - 1)];
}

/// Whether spheres cross so many cells between two collisions that their balls should be as wide as
/// the cells.
bool fly_far_alone(double free_path, int dimension) {
  constexpr double far = 1000;  // in widths: below, they keep the digits that they have
  return free_path > far * most_width(dimension);
}

template <int Dim, class Real>
double free_path_in(const ShearBox<Dim, Real>& box, std::int32_t spheres) {
  return mean_free_path(static_cast<double>(box.volume()) / spheres, Dim);
}

/// How far apart the reference positions of equal spheres on one list may be, diameters.
///
/// \param share  volume for each sphere, diameters^dimension
double width_for_lists(double share, int dimension, double diameter) {
  constexpr double spheres_a_cell = 3.5;
  constexpr double cells_a_sphere = 2;  // at most, however dilute
  constexpr double least = 1.1;
  const double width = std::pow(spheres_a_cell * share, 1.0 / dimension);
  const double sparse = std::pow(share / cells_a_sphere, 1.0 / dimension);
  const double most = most_width(dimension) * diameter;
  return std::max({std::min(width, most), sparse, least * diameter});
}

/// Of cells in which spheres are looked for to be put on lists, diameters. The largest find as much
/// room in their balls as spheres of the mean size would in a system of these alone.
double width_for_lists(double share, int dimension, const Sizes& sizes) {
  const double width = width_for_lists(share, dimension, sizes.mean);
  if (!(sizes.largest > sizes.mean)) return width;
  constexpr double least = 0.02;  // of the largest diameter, so that grains are small beside it
  return sizes.largest + std::max(width - sizes.mean, least * sizes.largest);
}

/// How many lists of a sphere last together as long as layers slide by a cell: two, or more where
/// small spheres would have to look far along wide cells.
///
/// \param distance  of the reference positions of two spheres of the mean size, diameters
int lists_a_cell(double distance, double width) {
  constexpr double most = 4;  // with more of them most lists end before their sphere has moved away
  return static_cast<int>(std::clamp(std::ceil(width / distance), 2.0, most));
}

/// The same without lists; 0 where spheres are too close together for that, or too far apart.
///
/// The fraction that they would fill if all were as large as the largest is what was measured: in 3
/// dimensions, up to 0.25. No round number, so that rounding does not decide.
double width_without_lists(double share, int dimension, double largest_diameter) {
  constexpr double spheres_a_cell = 0.5;
  constexpr double densest = 0.2775;
  constexpr double least = 1.02;
  const double volume = largest_diameter * largest_diameter * largest_diameter;
  if (dimension != 3 || unit_sphere_volume(3) * volume / share > densest) return 0;
  const double width = std::max(std::cbrt(spheres_a_cell * share), least * largest_diameter);
  return width < most_width(3) * largest_diameter ? width : 0;
}

template <int Dim, class Real>
ListRange list_range_of(const ShearBox<Dim, Real>& box, std::int32_t spheres, const Sizes& sizes,
                        bool are_alone) {
  constexpr int grains_of_error =
      4;  // of the distance of two reference positions; twice that is left
  double widest = 0;
  double width = width_for_lists(static_cast<double>(box.volume()) / spheres, Dim, sizes);
  for (int axis = 0; axis < Dim; ++axis) {
    const double here = static_cast<double>(box.cell_width()[axis]);
    widest = std::max(widest, here);
    const bool is_alone = box.is_closed(axis) && box.cells()[static_cast<std::size_t>(axis)] == 2;
    if (!is_alone) width = std::min(width, here);  // alone but for the empty cell beyond the wall
  }
  width = std::min(width, widest);  // what the grains of a cell measure
  ListRange list_range{};
  list_range.grain = widest / ReferenceCells::grains_a_cell;
  list_range.is_wide = are_alone;
  // Of places 300 diameters apart 1e-11 diameters^2 are rounding, far below what may_touch()
  // allows.
  constexpr double widest_ball = 300;
  const double most = are_alone ? widest_ball : most_width(Dim) * sizes.largest;
  width = std::min(width, std::max(most, sizes.largest + 100 * list_range.grain));
  list_range.reach = (width - sizes.largest) / 2 - grains_of_error * list_range.grain;
  list_range.distance = width;
  list_range.lists_a_cell = lists_a_cell(width - sizes.largest + sizes.mean, width);
  list_range.window = box.is_sheared()
                          ? static_cast<double>(box.clock_unit()) / list_range.lists_a_cell
                          : std::numeric_limits<double>::infinity();
  // Which a `float` holds, however long the time unit of the case is.
  const auto clock_unit = static_cast<double>(box.clock_unit());
  list_range.expiry_unit = box.is_sheared() ? std::ldexp(1.0, std::ilogb(clock_unit)) : 1.0;
  constexpr std::array<double, 3> unit_balls{2, std::numbers::pi, 4 * std::numbers::pi / 3};
  const double usual = width - sizes.largest + sizes.mean;  // distance of reference positions
  list_range.neighbours = spheres / static_cast<double>(box.volume()) *
                          unit_balls[static_cast<std::size_t>(Dim - 1)] * std::pow(usual, Dim);
  constexpr double scatter = 1.4;  // large ones have more, and those where wide cells slide
  if (sizes.largest > sizes.mean) list_range.neighbours *= scatter;
  constexpr std::int32_t many = 100;  // fewer are fast anyway, and keep the digits that they have
  list_range.is_dilute =
      (spheres >= many || are_alone) && free_path_in(box, spheres) > 2 * list_range.reach;
  return list_range;
}

}  // namespace

double fitting_cell_width(const Filling& filling) {
  const auto& sides = filling.sides;
  const int dimension = static_cast<int>(sides.size());
  const double volume = std::accumulate(sides.begin(), sides.end(), 1.0, std::multiplies<>());
  const double share = volume / static_cast<double>(filling.spheres);
  const double narrow = width_without_lists(share, dimension, filling.sizes.largest);
  if (filling.is_straight && narrow > 0) {
    constexpr double margin = 1e-8;  // more than ShearBox takes
    Steps<3> cells{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      cells[axis] = static_cast<int>(std::min(sides[axis] / (narrow * (1 + margin)), 1e6));
    }
    if (CellSearch<3>::has_room_in(cells)) return narrow;
  }
  return width_for_lists(share, dimension, filling.sizes);
}

template <int Dim, class Real>
bool cells_suffice(const ShearBox<Dim, Real>& box, std::int32_t spheres, const Sizes& sizes) {
  const double share = static_cast<double>(box.volume()) / spheres;
  const double narrow = width_without_lists(share, Dim, sizes.largest);
  if (narrow == 0 || !CellSearch<Dim>::has_room_in(box.cells())) return false;
  for (int axis = 0; axis < Dim; ++axis) {
    // Wider ones are for lists.
    constexpr double widest = 1.3;
    const auto width = static_cast<double>(box.cell_width()[axis]);
    if (width < narrowest_cell * sizes.largest || width > widest * narrow) return false;
  }
  return true;
}

template <int Dim, class Real>
ListRange list_range_in(const ShearBox<Dim, Real>& box, std::int32_t spheres, const Sizes& sizes) {
  const bool are_alone = sizes.largest == 1 && fly_far_alone(free_path_in(box, spheres), Dim);
  return list_range_of(box, spheres, sizes, are_alone);
}

template <int Dim, class Real>
ListRange list_range_in_crowd(const ShearBox<Dim, Real>& box, std::int32_t spheres,
                              const Sizes& sizes) {
  return list_range_of(box, spheres, sizes, false);
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                                         \
  template ListRange list_range_in(const ShearBox<Dim, Real>&, std::int32_t, const Sizes&);       \
  template ListRange list_range_in_crowd(const ShearBox<Dim, Real>&, std::int32_t, const Sizes&); \
  template bool cells_suffice(const ShearBox<Dim, Real>&, std::int32_t, const Sizes&);
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
