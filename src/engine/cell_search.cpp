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

template <int Dim>
void CellSearch<Dim>::insert(std::int32_t sphere, const Steps<Dim>& cell) {
  members_.insert(sphere, rows_.index(cell));
  repeat(cell);
  const std::size_t most = most_cells_around * members_.most() + CellMembers::slack;
  if (nearby_.size() < most) nearby_.resize(most);
}

template <int Dim>
void CellSearch<Dim>::remove(std::int32_t sphere, const Steps<Dim>& cell) {
  members_.remove(sphere, rows_.index(cell));
  repeat(cell);
}

/// The first cells of a row stand once more behind its end.
template <int Dim>
void CellSearch<Dim>::repeat(const Steps<Dim>& cell) {
  if (cell[0] >= CellRows<Dim>::repeated) return;
  const std::int32_t number = rows_.index(cell);
  members_.repeat(number, number + rows_.row_length());
}

template <int Dim>
void CellSearch<Dim>::prefetch(const SlidingCells<Dim>& cells, const Steps<Dim>& home) const {
  Runs runs;
  const CellRun* const end = rows_.around(cells, home, reach(cells, home), runs.data());
  for (const CellRun* run = runs.data(); run != end; ++run) members_.prefetch(*run);
}

template <int Dim>
template <class Cells>
std::span<const Neighbour> CellSearch<Dim>::members_of(Cells&& cells) const {
  Neighbour* const begin = nearby_.data();
  Neighbour* const end = members_.find(cells, begin);
  if (end != begin) std::fill_n(end, 3, end[-1]);
  return {begin, end};
}

template <int Dim>
std::span<const Neighbour> CellSearch<Dim>::around(const SlidingCells<Dim>& cells,
                                                   const Steps<Dim>& home) const {
  Runs runs;
  return members_of(
      std::span(runs.data(), rows_.around(cells, home, reach(cells, home), runs.data())));
}

template <int Dim>
std::span<const Neighbour> CellSearch<Dim>::beyond(const SlidingCells<Dim>& cells,
                                                   const Crossing& crossing) const {
  const auto& [axis, direction, from, to] = crossing;
  const Reach reach = this->reach(cells, to);
  if (axis == 0) {
    std::array<int, 3> columns;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      columns[k] = direction > 0 ? reach[k].to : reach[k].from;
    }
    return members_of(rows_.one_of_each_row(cells, to, columns));
  }
  Runs runs;
  CellRun* end = runs.data();
  if (axis == 1) {
    end = columns_behind(cells, crossing, reach, end);
    end = rows_.in_layer(cells, to, direction, reach[static_cast<std::size_t>(direction + 1)], end);
  } else {
    end = rows_.in_row(cells, to, direction, reach, end);
  }
  return members_of(std::span(runs.data(), end));
}

/// Of the layer that a sphere has left it has seen the columns beside its own; with layers that
/// slide one or two more are seen from the next layer.
template <int Dim>
CellRun* CellSearch<Dim>::columns_behind(const SlidingCells<Dim>& cells, const Crossing& crossing,
                                         const Reach& reach, CellRun* runs) const {
  const int behind = -crossing.direction;
  const auto [from, to] = reach[static_cast<std::size_t>(behind + 1)];
  if (from == -1 && to == 1) return runs;
  const int own = cells.reached(crossing.to, crossing.from).steps[0];
  if (from <= own - 2) {
    runs = rows_.in_layer(cells, crossing.to, behind, {from, own - 2}, runs);
  }
  if (own + 2 <= to) runs = rows_.in_layer(cells, crossing.to, behind, {own + 2, to}, runs);
  return runs;
}

template <int Dim>
std::span<const Neighbour> CellSearch<Dim>::slid_near(const SlidingCells<Dim>& cells,
                                                      const Steps<Dim>& home) const {
  constexpr int above = 1;
  const int column = reach(cells, home)[above + 1].from;
  Runs runs;
  return members_of(
      std::span(runs.data(), rows_.in_layer(cells, home, above, {column, column}, runs.data())));
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
