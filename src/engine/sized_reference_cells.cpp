#include "engine/sized_reference_cells.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>

#include "engine/neighbour_lists.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

/// Diameters within a class, largest over least.
constexpr double ratio_in_a_class = 2;

/// The last one takes all that are smaller still.
constexpr std::size_t most_classes = 16;

/// The largest code of size: labels stay positive.
constexpr int most_code = 127;

int grains_of(double length, double grain) { return static_cast<int>(std::ceil(length / grain)); }

int floor_of_quotient(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

/// Into how many parts a cell suits so many spheres.
///
/// \param volume  for each of them, diameters^dimension
int parts_for(double width, double volume, int dimension) {
  constexpr double spheres_a_part = 3.5;
  constexpr int most = ReferenceCells::grains_a_cell / 8;
  const double wanted = std::pow(spheres_a_part * volume, 1.0 / dimension);
  return static_cast<int>(std::clamp(std::round(width / wanted), 1.0, double{most}));
}

}  // namespace

template <int Dim>
SizedReferenceCells<Dim>::SizedReferenceCells(const SlidingCells<Dim>& cells,
                                              const ReferenceGrid<Dim>& grid,
                                              std::span<const double> radii)
    : grid_(grid), sizes_(radii.size()) {
  std::vector<double> sorted(radii.begin(), radii.end());
  std::sort(sorted.begin(), sorted.end(), std::greater<>());
  for (auto first = sorted.begin(); first != sorted.end();) {
    const auto is_of_class = [&](double radius) { return radius * ratio_in_a_class >= *first; };
    const bool is_last = classes_.size() + 1 == most_classes;
    const auto last =
        is_last ? sorted.end() : std::partition_point(first, sorted.end(), is_of_class);
    classes_.push_back(class_of(cells, {first, last}));
    first = last;
  }
  for (std::size_t i = 0; i < radii.size(); ++i) sizes_[i] = size_of(radii[i]);
}

/// \param radii  of its spheres, the largest first
template <int Dim>
typename SizedReferenceCells<Dim>::Class SizedReferenceCells<Dim>::class_of(
    const SlidingCells<Dim>& cells, std::span<const double> radii) const {
  Class sizes;
  sizes.least = grains_of(radii.back(), grid_.grain);
  const int span = grains_of(radii.front(), grid_.grain) - sizes.least;
  while ((most_code << sizes.shift) < span) ++sizes.shift;
  const int codes = (span + (1 << sizes.shift) - 1) >> sizes.shift;
  sizes.most = sizes.least + (codes << sizes.shift);
  const double volume = grid_.volume / static_cast<double>(radii.size());
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    const int grains = grid_.cell_grains[axis];
    sizes.parts[axis] = parts_for(grains * grid_.grain, volume, Dim);
    sizes.scale[axis] = static_cast<double>(sizes.parts[axis]) / grains;
  }
  sizes.cells = ReferenceCells(cells.count() * sizes.parts_of_a_cell());
  return sizes;
}

template <int Dim>
typename SizedReferenceCells<Dim>::Size SizedReferenceCells<Dim>::size_of(double radius) const {
  const int grains = grains_of(radius, grid_.grain);
  const auto fits = [&](const Class& sizes) { return grains >= sizes.least; };
  const auto sizes = std::find_if(classes_.begin(), classes_.end(), fits);
  assert(sizes != classes_.end());
  const int code = (grains - sizes->least + (1 << sizes->shift) - 1) >> sizes->shift;
  return {static_cast<std::uint8_t>(sizes - classes_.begin()), static_cast<std::uint8_t>(code)};
}

template <int Dim>
int SizedReferenceCells<Dim>::Class::parts_of_a_cell() const {
  int product = 1;
  for (const int number : parts) product *= number;
  return product;
}

/// The part of a cell in which a reference position is.
template <int Dim>
std::int32_t SizedReferenceCells<Dim>::Class::part_of(std::int32_t cell,
                                                      const ReferencePosition& reference) const {
  int part = 0;
  for (std::size_t axis = Dim; axis-- > 0;) {
    part = part * parts[axis] + part_along(axis, reference.place[axis]);
  }
  return cell * parts_of_a_cell() + part;
}

/// Grains, rounded up as its code tells.
template <int Dim>
int SizedReferenceCells<Dim>::radius(std::int32_t sphere) const {
  const Size size = this->size(sphere);
  const Class& sizes = classes_[size.number];
  return sizes.least + (size.code << sizes.shift);
}

/// Under which a sphere is found: its number and the code of its size.
template <int Dim>
std::int32_t SizedReferenceCells<Dim>::label(std::int32_t sphere) const {
  return sphere | size(sphere).code << Neighbour::sphere_bits;
}

template <int Dim>
void SizedReferenceCells<Dim>::insert(std::int32_t sphere, std::int32_t cell,
                                      const ReferencePosition& reference) {
  Class& sizes = classes_[size(sphere).number];
  sizes.cells.insert(label(sphere), sizes.part_of(cell, reference), reference);
}

template <int Dim>
void SizedReferenceCells<Dim>::remove(std::int32_t sphere, std::int32_t cell,
                                      const ReferencePosition& reference) {
  Class& sizes = classes_[size(sphere).number];
  sizes.cells.remove(label(sphere), sizes.part_of(cell, reference));
}

template <int Dim>
std::span<Neighbour> SizedReferenceCells<Dim>::find(const SlidingCells<Dim>& cells,
                                                    const Viewer& viewer,
                                                    std::vector<Neighbour>& nearby) const {
  std::size_t found = 0;
  for (const Class& sizes : classes_) {
    find_rows(cells, viewer, sizes);
    std::size_t most = found + ReferenceCells::slack;
    for (const Row& row : rows_) {
      most += static_cast<std::size_t>(row.last - row.first + 1) * sizes.cells.room();
    }
    if (nearby.size() < most) nearby.resize(most);
    const ReferenceCells::SizedRange range{radius(viewer.sphere) + sizes.least + viewer.beyond,
                                           sizes.shift, sizes.row_step(grid_.cell_grains[0])};
    const Neighbour* const end = sizes.cells.find(rows_, range, nearby.data() + found);
    found = static_cast<std::size_t>(end - nearby.data());
  }
  return {nearby.data(), found};
}

template <int Dim>
void SizedReferenceCells<Dim>::prefetch(const SlidingCells<Dim>& cells,
                                        const Viewer& viewer) const {
  constexpr std::int32_t most_in_cache = 1024;
  for (const Class& sizes : classes_) {
    if (sizes.parts_of_a_cell() * cells.count() <= most_in_cache) continue;
    find_rows(cells, viewer, sizes);
    for (const Row& row : rows_) sizes.cells.prefetch(row.first, row.last);
  }
}

/// Finds the rows of parts in which spheres of a class can be near.
template <int Dim>
void SizedReferenceCells<Dim>::find_rows(const SlidingCells<Dim>& cells, const Viewer& viewer,
                                         const Class& sizes) const {
  const int distance = radius(viewer.sphere) + sizes.most + viewer.beyond;
  const auto& grains = grid_.cell_grains;
  typename SlidingCells<Dim>::Reach columns;
  for (const int layers : {-1, 0, 1}) {
    const auto layer = static_cast<std::size_t>(layers + 1);
    const int middle = viewer.place[0] - viewer.slid[layer];
    const int aside = distance + (layers != 0 ? viewer.slide : 0);
    columns[layer] = {floor_of_quotient(middle - aside, grains[0]),
                      floor_of_quotient(middle + aside, grains[0])};
    if (grid_.is_closed_along_x) {  // beyond the walls there are no spheres
      columns[layer] = {std::max(columns[layer].from, -1), std::min(columns[layer].to, 1)};
    }
  }
  const auto below = [&](std::size_t axis) { return viewer.place[axis] < distance ? -1 : 0; };
  const auto above = [&](std::size_t axis) {
    return viewer.place[axis] + distance > grains[axis] ? 1 : 0;
  };
  typename SlidingCells<Dim>::Rows near;
  if constexpr (Dim > 1) near.first_layer = below(1), near.last_layer = above(1);
  if constexpr (Dim > 2) near.first_row = below(2), near.last_row = above(2);
  rows_.clear();
  const auto add = [&](std::int32_t first, std::int32_t last, PeriodicImage periodic_image,
                       const Steps<Dim>& steps) {
    const int layers = SlidingCells<Dim>::layers(steps);
    Row row{first, last, periodic_image, viewer.place,
            static_cast<std::int16_t>(layers != 0 ? viewer.slide : 0)};
    row.place[0] -= static_cast<std::int16_t>(viewer.slid[static_cast<std::size_t>(layers + 1)]);
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      row.place[axis] -= static_cast<std::int16_t>(steps[axis] * grains[axis]);
    }
    if (sizes.is_undivided()) {
      rows_.push_back(row);
      return;
    }
    for (std::int32_t cell = first; cell <= last; ++cell) {
      add_parts(cell, row, distance, sizes);
      row.place[0] -= static_cast<std::int16_t>(grains[0]);
    }
  };
  cells.for_each_run(viewer.home, columns, near, add);
}

/// Adds the rows of parts of one cell.
///
/// \param row  in which its place is from the lower corner of that cell
template <int Dim>
void SizedReferenceCells<Dim>::add_parts(std::int32_t cell, Row row, int distance,
                                         const Class& sizes) const {
  std::array<int, 3> first{};
  std::array<int, 3> last{};
  std::array<int, 3> parts{1, 1, 1};
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    const int aside = distance + (axis == 0 ? row.slide : 0);
    parts[axis] = sizes.parts[axis];
    first[axis] = sizes.part_along(axis, row.place[axis] - aside);
    last[axis] = sizes.part_along(axis, row.place[axis] + aside);
  }
  const std::int32_t base = cell * sizes.parts_of_a_cell();
  for (int z = first[2]; z <= last[2]; ++z) {
    for (int y = first[1]; y <= last[1]; ++y) {
      const std::int32_t line = base + (z * parts[1] + y) * parts[0];
      row.first = line + first[0];
      row.last = line + last[0];
      rows_.push_back(row);
    }
  }
}

#define ZENOSPHERE_INSTANTIATE(Dim) template class SizedReferenceCells<Dim>;
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
