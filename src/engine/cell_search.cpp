#include "engine/cell_search.hpp"

#include <algorithm>
#include <array>

#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim>
bool CellSearch<Dim>::has_room_in(const Steps<Dim>& cells) {
  constexpr int least_along_x = 7;
  constexpr int least = 4;
  return cells[0] >= least_along_x &&
         std::all_of(cells.begin() + 1, cells.end(), [](int count) { return count >= least; });
}

/// A layer that has slid by a part s of a cell has its column d from d + s to d + s + 1. Spheres
/// there and between 0 and 1 can touch if that is less than a cell away: -2 - s < d < 2 - s.
template <int Dim>
typename CellSearch<Dim>::Reach CellSearch<Dim>::reach(const SlidingCells<Dim>& cells,
                                                       const Steps<Dim>& home) const {
  Reach reach;
  reach.fill({-1, 1});
  if constexpr (Dim > 1) {
    const int slide = slides_.layers ? 1 : 0;
    const int displacement = slides_.images ? 1 : 0;
    reach[0].to += slide + (home[1] == 0 ? displacement : 0);
    reach[2].from -= slide + (home[1] + 1 == cells.cells()[1] ? displacement : 0);
  }
  return reach;
}

/// A search that writes one run of cells after the other.
template <int Dim>
class CellSearch<Dim>::Found {
 public:
  explicit Found(const CellSearch& search) : search_(search), end_(search.nearby_.data()) {}

  void add(const Reach& reach, const Rows& rows, const SlidingCells<Dim>& cells,
           const Steps<Dim>& home) {
    cells.for_each_run(home, reach, rows,
                       [&](std::int32_t first, std::int32_t last, PeriodicImage periodic_image,
                           const Steps<Dim>&) {
                         end_ = search_.members_.find(first, last, periodic_image, end_);
                       });
  }
  std::span<const Neighbour> all() const {
    Neighbour* const begin = search_.nearby_.data();
    if (end_ != begin) std::fill_n(end_, 3, end_[-1]);
    return {begin, end_};
  }

 private:
  const CellSearch& search_;
  Neighbour* end_;
};

template <int Dim>
void CellSearch<Dim>::insert(std::int32_t sphere, std::int32_t cell) {
  members_.insert(sphere, cell);
  const std::size_t most = most_cells_around * members_.room() + CellMembers::slack;
  if (nearby_.size() < most) nearby_.resize(most);
}

template <int Dim>
std::span<const Neighbour> CellSearch<Dim>::around(const SlidingCells<Dim>& cells,
                                                   const Steps<Dim>& home) const {
  Found found(*this);
  found.add(reach(cells, home), Rows(), cells, home);
  return found.all();
}

template <int Dim>
std::span<const Neighbour> CellSearch<Dim>::beyond(const SlidingCells<Dim>& cells,
                                                   const Crossing& crossing) const {
  const auto [axis, direction, from, to] = crossing;
  Reach reach = this->reach(cells, to);
  Rows rows;
  Found found(*this);
  if (axis == 0) {
    for (auto& columns : reach) {
      columns.from = columns.to = direction > 0 ? columns.to : columns.from;
    }
  } else if (axis == 1) {
    rows.first_layer = rows.last_layer = direction;
    add_columns_behind(crossing, reach, cells, found);
  } else {
    rows.first_row = rows.last_row = direction;
  }
  found.add(reach, rows, cells, to);
  return found.all();
}

/// Of the layer that a sphere has left it has seen the columns beside its own; with layers that
/// slide one or two more are seen from the next layer.
template <int Dim>
void CellSearch<Dim>::add_columns_behind(const Crossing& crossing, const Reach& reach,
                                         const SlidingCells<Dim>& cells, Found& found) const {
  const auto [from, to] = reach[static_cast<std::size_t>(1 - crossing.direction)];
  if (from == -1 && to == 1) return;
  const int own = cells.reached(crossing.to, crossing.from).steps[0];
  const Rows behind{.first_layer = -crossing.direction, .last_layer = -crossing.direction};
  const auto add = [&](int first, int last) {
    Reach columns;
    columns.fill({first, last});
    if (first <= last) found.add(columns, behind, cells, crossing.to);
  };
  add(from, own - 2);
  add(own + 2, to);
}

template <int Dim>
std::span<const Neighbour> CellSearch<Dim>::slid_near(const SlidingCells<Dim>& cells,
                                                      const Steps<Dim>& home) const {
  Reach reach = this->reach(cells, home);
  reach[2].to = reach[2].from;
  Found found(*this);
  found.add(reach, {.first_layer = 1, .last_layer = 1}, cells, home);
  return found.all();
}

template <int Dim>
std::optional<PeriodicImage> CellSearch<Dim>::periodic_image(const SlidingCells<Dim>& cells,
                                                             const Steps<Dim>& from,
                                                             const Steps<Dim>& to) const {
  const auto [steps, periods] = cells.reached(from, to);
  for (std::size_t axis = 1; axis < Dim; ++axis) {
    if (steps[axis] < -1 || steps[axis] > 1) return std::nullopt;
  }
  const int layers = SlidingCells<Dim>::layers(steps);
  const auto columns = reach(cells, from)[static_cast<std::size_t>(layers + 1)];
  if (steps[0] < columns.from || steps[0] > columns.to) return std::nullopt;
  return PeriodicImage(periods, layers);
}

#define ZENOSPHERE_INSTANTIATE(Dim) template class CellSearch<Dim>;
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
