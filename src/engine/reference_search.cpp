#include "engine/reference_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim>
ReferenceSearch<Dim>::ReferenceSearch(const SlidingCells<Dim>& cells,
                                      const ReferenceGrid<Dim>& grid, const ListRange& range,
                                      std::span<const double> radii)
    : grid_(grid), range_(range), cells_(radii.empty() ? cells.count() : 0) {
  const bool is_sheared = std::isfinite(range.window);
  if (is_sheared) slide_grains_ = grid.cell_grains[0] / (2 * range.lists_a_cell) + 1;
  if (radii.empty()) return;
  largest_ = 2 * *std::max_element(radii.begin(), radii.end());
  sized_cells_.emplace(cells, grid, radii);
}

template <int Dim>
void ReferenceSearch<Dim>::insert(std::int32_t sphere, std::int32_t cell,
                                  const ReferencePosition& reference) {
  if (!sized_cells_) [[likely]]
    return cells_.insert(sphere, cell, reference);
  sized_cells_->insert(sphere, cell, reference);
}

template <int Dim>
void ReferenceSearch<Dim>::remove(std::int32_t sphere, std::int32_t cell,
                                  const ReferencePosition& reference) {
  if (!sized_cells_) [[likely]]
    return cells_.remove(sphere, cell);
  sized_cells_->remove(sphere, cell, reference);
}

template <int Dim>
std::span<Neighbour> ReferenceSearch<Dim>::find(const SlidingCells<Dim>& cells,
                                                const Viewer& viewer) {
  if (!sized_cells_) [[likely]]
    return find_of_one_size(cells, viewer);
  return sized_cells_->find(cells, sized(viewer), nearby_);
}

template <int Dim>
void ReferenceSearch<Dim>::prefetch(const SlidingCells<Dim>& cells, const Viewer& viewer) const {
  if (sized_cells_) return sized_cells_->prefetch(cells, sized(viewer));
  cells.for_each_run(viewer.home, columns_within_reach(viewer),
                     [&](std::int32_t first, std::int32_t last, PeriodicImage, const Steps<Dim>&) {
                       cells_.prefetch(first, last);
                     });
}

template <int Dim>
std::span<Neighbour> ReferenceSearch<Dim>::find_of_one_size(const SlidingCells<Dim>& cells,
                                                            const Viewer& viewer) {
  const SlidGrains slid = slid_grains(viewer.slides);
  std::array<ReferenceCells::Row, most_cells_around> rows;  // a cell in each at least
  std::size_t count = 0;
  const auto add_row = [&](std::int32_t first, std::int32_t last, PeriodicImage periodic_image,
                           const Steps<Dim>& steps) {
    const int layers = SlidingCells<Dim>::layers(steps);
    ReferenceCells::Row& row = rows[count++];
    const int either_way = layers != 0 ? slid.either_way : 0;
    row = {first, last, periodic_image, viewer.place, static_cast<std::int16_t>(either_way)};
    const int along_x = slid.layers[static_cast<std::size_t>(layers + 1)];
    row.place[0] -= static_cast<std::int16_t>(along_x);
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      row.place[axis] -= static_cast<std::int16_t>(steps[axis] * grid_.cell_grains[axis]);
    }
  };
  cells.for_each_run(viewer.home, columns_within_reach(viewer), add_row);
  const double distance = range_.distance / grid_.grain;
  const ReferenceCells::Range near{static_cast<std::int32_t>(distance * distance),
                                   static_cast<std::int16_t>(grid_.cell_grains[0])};
  nearby_.resize(most_cells_around * cells_.room() + ReferenceCells::slack);
  const Neighbour* const end = cells_.find(std::span(rows).first(count), near, nearby_.data());
  return {nearby_.data(), static_cast<std::size_t>(end - nearby_.data())};
}

/// The viewer as spheres of several sizes are looked for.
template <int Dim>
typename SizedReferenceCells<Dim>::Viewer ReferenceSearch<Dim>::sized(const Viewer& viewer) const {
  const double beyond = range_.distance - largest_;
  const SlidGrains slid = slid_grains(viewer.slides);
  return {.sphere = viewer.sphere,
          .home = viewer.home,
          .place = viewer.place,
          .slid = slid.layers,
          .slide = slid.either_way,
          .beyond = static_cast<int>(std::ceil(beyond / grid_.grain))};
}

template <int Dim>
typename ReferenceSearch<Dim>::SlidGrains ReferenceSearch<Dim>::slid_grains(
    const LayerSlides& slides) const {
  const auto grains = [&](double columns) {
    return static_cast<int>(columns * grid_.cell_grains[0] + 0.5) + slide_grains_;
  };
  return {{-grains(slides.below), 0, grains(slides.above)}, slide_grains_};
}

/// The columns of the layers below, beside and above that come near the viewer while a list lasts.
template <int Dim>
typename SlidingCells<Dim>::Reach ReferenceSearch<Dim>::columns_within_reach(
    const Viewer& viewer) const {
  const double place = viewer.place[0] * grid_.grain / grid_.cell_width;
  const double window = slide_grains_ > 0 ? 1.0 / range_.lists_a_cell : 0;
  const double distance = range_.distance / grid_.cell_width;
  typename SlidingCells<Dim>::Reach reach;
  for (const int layers : {-1, 0, 1}) {
    // The cell of column d then covers d + slide to d + slide + 1, and slides on by `window`.
    double least = 0;
    double most = 0;
    if (layers != 0) {
      least = layers > 0 ? viewer.slides.above : -viewer.slides.below - window;
      most = least + window;
    }
    int from = static_cast<int>(std::floor(place - distance - most));
    int to = static_cast<int>(std::floor(place + distance - least));
    if (grid_.is_closed_along_x) {
      // A cell alone may be narrower, but beyond the walls there are no spheres.
      from = std::max(from, -1);
      to = std::min(to, 1);
    }
    reach[static_cast<std::size_t>(layers + 1)] = {from, to};
  }
  return reach;
}

#define ZENOSPHERE_INSTANTIATE(Dim) template class ReferenceSearch<Dim>;
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
