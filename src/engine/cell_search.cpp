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
  members_.repeat(rows_.index(cell), cell[0] < CellRows<Dim>::repeated ? rows_.row_length() : 0);
}

template <int Dim>
void CellSearch<Dim>::prefetch(const SlidingCells<Dim>& cells, const Steps<Dim>& home) const {
  const CellBlock block = block_around(cells, home);
  for (std::size_t k = 0; k < block.run_count; ++k) {
    for (std::size_t row = 0; row < block.row_count; ++row) {
      members_.prefetch(block.runs[k].first + block.rows[row]);
    }
  }
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
CellBlock CellSearch<Dim>::block_around(const SlidingCells<Dim>& cells,
                                        const Steps<Dim>& home) const {
  if (!has_slides()) return rows_.around(home);
  CellBlock block = rows_.all_rows(home);
  rows_.add_columns(cells, home, reach(cells, home), block);
  return block;
}

template <int Dim>
std::span<const Neighbour> CellSearch<Dim>::around(const SlidingCells<Dim>& cells,
                                                   const Steps<Dim>& home) const {
  return members_of(block_around(cells, home));
}

template <int Dim>
std::span<const Neighbour> CellSearch<Dim>::beyond(const SlidingCells<Dim>& cells,
                                                   const Crossing& crossing) const {
  const auto& [axis, direction, from, to] = crossing;
  if (!has_slides()) {
    return axis == 0 ? members_of(rows_.column_beside(to, direction))
                     : members_of(rows_.beside(to, axis, direction));
  }
  const Reach reach = this->reach(cells, to);
  if (axis == 0) {
    std::array<int, 3> columns;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      columns[k] = direction > 0 ? reach[k].to : reach[k].from;
    }
    return members_of(rows_.one_of_each_row(cells, to, columns));
  }
  if (axis == 1) {
    CellBlock block = rows_.all_rows(to);
    add_columns_behind(cells, crossing, reach, block);
    rows_.add_columns(cells, to, direction, reach[static_cast<std::size_t>(direction + 1)], block);
    return members_of(block);
  }
  CellBlock block = rows_.one_row(to, direction);
  rows_.add_columns(cells, to, reach, block);
  return members_of(block);
}

/// Of the layer that a sphere has left it has seen the columns beside its own; with layers that
/// slide one or two more are seen from the next layer.
template <int Dim>
void CellSearch<Dim>::add_columns_behind(const SlidingCells<Dim>& cells, const Crossing& crossing,
                                         const Reach& reach, CellBlock& block) const {
  const int behind = -crossing.direction;
  const auto [from, to] = reach[static_cast<std::size_t>(behind + 1)];
  if (from == -1 && to == 1) return;
  const int own = cells.reached(crossing.to, crossing.from).steps[0];
  if (from <= own - 2) rows_.add_columns(cells, crossing.to, behind, {from, own - 2}, block);
  if (own + 2 <= to) rows_.add_columns(cells, crossing.to, behind, {own + 2, to}, block);
}

template <int Dim>
std::span<const Neighbour> CellSearch<Dim>::slid_near(const SlidingCells<Dim>& cells,
                                                      const Steps<Dim>& home) const {
  constexpr int above = 1;
  const int column = reach(cells, home)[above + 1].from;
  CellBlock block = rows_.all_rows(home);
  rows_.add_columns(cells, home, above, {column, column}, block);
  return members_of(block);
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
