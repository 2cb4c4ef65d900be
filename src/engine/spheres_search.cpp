// Which spheres are near one whose list is rebuilt.

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/spheres.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

/// Three rows of three, in each of which at most five cells are within reach.
constexpr std::size_t most_cells_around = 3 * 3 * 5;

}  // namespace

/// All spheres whose balls come within a diameter of the ball of i while one slides past the
/// other.
template <int Dim, class Real>
std::span<Neighbour> Spheres<Dim, Real>::neighbours_of(std::int32_t i, const Real& when) {
  if (!is_mixture_) [[likely]]
    return neighbours_of_one_size(i, when);
  const std::span near =
      are_of_one_size() ? neighbours_of_one_size(i, when) : neighbours_by_size(i, when);
  return grains_.is_immobile(i) ? without_immobile(near) : near;
}

template <int Dim, class Real>
std::span<Neighbour> Spheres<Dim, Real>::neighbours_of_one_size(std::int32_t i, const Real& when) {
  const Steps<Dim> home = cells_.coordinates((*this)[i].cell);
  const ReferencePosition& reference = this->reference(i);
  const Slides slid = slides(home, when);
  const SlidGrains slid_grains = this->slid_grains(slid);
  const double column =
      reference.place[0] * list_range_.grain / static_cast<double>(box_.cell_width()[0]);
  std::array<ReferenceCells::Row, most_cells_around> rows;  // a cell in each at least
  std::size_t count = 0;
  const auto add_row = [&](std::int32_t first, std::int32_t last, PeriodicImage periodic_image,
                           const Steps<Dim>& steps) {
    const int layers = SlidingCells<Dim>::layers(steps);
    ReferenceCells::Row& row = rows[count++];
    const int either_way = layers != 0 ? slid_grains.either_way : 0;
    row = {first, last, periodic_image, reference.place, static_cast<std::int16_t>(either_way)};
    const int along_x = slid_grains.layers[static_cast<std::size_t>(layers + 1)];
    row.place[0] -= static_cast<std::int16_t>(along_x);
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      row.place[axis] -= static_cast<std::int16_t>(steps[axis] * cell_grains_[axis]);
    }
  };
  cells_.for_each_run(home, columns_within_reach(column, slid), add_row);
  const double distance = list_range_.distance / list_range_.grain;
  const ReferenceCells::Range range{static_cast<std::int32_t>(distance * distance),
                                    static_cast<std::int16_t>(cell_grains_[0])};
  nearby_.resize(most_cells_around * reference_cells_.room() + ReferenceCells::slack);
  const Neighbour* const end =
      reference_cells_.find(std::span(rows).first(count), range, nearby_.data());
  return {nearby_.data(), static_cast<std::size_t>(end - nearby_.data())};
}

template <int Dim, class Real>
typename Spheres<Dim, Real>::SlidGrains Spheres<Dim, Real>::slid_grains(const Slides& slid) const {
  const auto grains = [&](double columns) {
    return static_cast<int>(columns * cell_grains_[0] + 0.5) + slide_grains_;
  };
  return {{-grains(slid.below), 0, grains(slid.above)}, slide_grains_};
}

template <int Dim, class Real>
void Spheres<Dim, Real>::prefetch_cells(std::int32_t i, const Real& when) const {
  Sphere sphere = (*this)[i];
  if (!search_) go_home(sphere, when, {});
  const Steps<Dim> home = cells_.coordinates(sphere.cell);
  if (search_) return search_->prefetch(cells_, home);
  if (sized_cells_) {
    const auto place = place_in_cell(position_at(sphere, when), sphere.cell);
    return sized_cells_->prefetch(cells_, viewer(i, home, place, when));
  }
  const Real column = position_at(sphere, when)[0] / box_.cell_width()[0] - home[0];
  cells_.for_each_run(home, columns_within_reach(static_cast<double>(column), slides(home, when)),
                      [&](std::int32_t first, std::int32_t last, PeriodicImage, const Steps<Dim>&) {
                        reference_cells_.prefetch(first, last);
                      });
}

/// By how much of a cell each layer has slid against the one below it, and beyond the faces of the
/// box the images are displaced besides; both beside whole cells, in [0, 2].
template <int Dim, class Real>
typename Spheres<Dim, Real>::Slides Spheres<Dim, Real>::slides(const Steps<Dim>& home,
                                                               const Real& when) const {
  double slid = 0;
  if (box_.is_sheared()) {
    slid = std::clamp(static_cast<double>(when / box_.clock_unit()), 0.0, 1.0);
  }
  Slides slides{slid, slid};
  if constexpr (Dim > 1) {
    if (home[1] == 0) slides.below += odd_offset_;
    if (home[1] + 1 == box_.cells()[1]) slides.above += odd_offset_;
  }
  return slides;
}

/// The columns of the layers below, beside and above that come near a place while a list lasts.
///
/// \param place  along x, from the lower side of its cell, in columns
template <int Dim, class Real>
typename SlidingCells<Dim>::Reach Spheres<Dim, Real>::columns_within_reach(
    double place, const Slides& slid) const {
  const double window = box_.is_sheared() ? 1.0 / list_range_.lists_a_cell : 0;
  const double distance = list_range_.distance / static_cast<double>(box_.cell_width()[0]);
  typename SlidingCells<Dim>::Reach reach;
  for (const int layers : {-1, 0, 1}) {
    // The cell of column d then covers d + slide to d + slide + 1, and slides on by `window`.
    double least = 0;
    double most = 0;
    if (layers != 0) {
      least = layers > 0 ? slid.above : -slid.below - window;
      most = least + window;
    }
    int from = static_cast<int>(std::floor(place - distance - most));
    int to = static_cast<int>(std::floor(place + distance - least));
    if (box_.is_closed(
            0)) {  // a cell alone may be narrower, but beyond the walls there are no spheres
      from = std::max(from, -1);
      to = std::min(to, 1);
    }
    reach[static_cast<std::size_t>(layers + 1)] = {from, to};
  }
  return reach;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                                         \
  template void Spheres<Dim, Real>::prefetch_cells(std::int32_t, const Real&) const;              \
  template std::span<Neighbour> Spheres<Dim, Real>::neighbours_of(std::int32_t, const Real&);     \
  template typename Spheres<Dim, Real>::Slides Spheres<Dim, Real>::slides(const Steps<Dim>&,      \
                                                                          const Real&) const;     \
  template typename Spheres<Dim, Real>::SlidGrains Spheres<Dim, Real>::slid_grains(const Slides&) \
      const;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
