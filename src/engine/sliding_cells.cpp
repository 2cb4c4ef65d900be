#include "engine/sliding_cells.hpp"

#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

/// `value` modulo `count`, in [0, count).
int modulo(int value, int count) {
  const int rest = value % count;
  return rest < 0 ? rest + count : rest;
}

/// Columns of an adjacent row that can be touched while it slides from 0 to 1 cell.
///
/// The row above runs to the right: its column d lies at d + s, 0 <= s < 1, and touches the
/// reach (-3/2, 3/2) for d = -2 ... 1; the row below runs to the left.
struct Columns {
  int from;
  int to;
};
Columns columns(int layer_step, bool sliding) {
  if (!sliding || layer_step == 0) return {-1, 1};
  return layer_step > 0 ? Columns{-2, 1} : Columns{-1, 2};
}

/// All combinations of -1, 0, 1 along the axes from `axis` on.
template <int Dim>
void add_rows(int axis, Steps<Dim> steps, bool sliding,
              typename SlidingCells<Dim>::Stencil& stencil) {
  if (axis == Dim) {
    const Columns reach = columns(SlidingCells<Dim>::layers(steps), sliding);
    stencil.push_back({steps, reach.from, reach.to});
    return;
  }
  for (const int step : {-1, 0, 1}) {
    steps[static_cast<std::size_t>(axis)] = step;
    add_rows<Dim>(axis + 1, steps, sliding, stencil);
  }
}

/// Whether a row lies at the rim that a sphere sees for the first time after a crossing of a face
/// that is not normal to x.
///
/// Along the gradient the far row is new, and of the row just left, which was three wide, the
/// fourth cell: testing that row again is harmless.
bool is_new(int step, int axis, int direction, bool sliding) {
  return step == direction || (sliding && axis == 1 && step == -direction);
}

}  // namespace

template <int Dim>
SlidingCells<Dim>::SlidingCells(const Steps<Dim>& cells, bool sliding, std::int32_t spheres,
                                std::optional<int> closed_axis)
    : cells_(cells),
      closed_axis_(closed_axis),
      next_(static_cast<std::size_t>(spheres), kNone),
      prev_(static_cast<std::size_t>(spheres), kNone) {
  std::int32_t count = 1;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    strides_[axis] = count;
    count *= cells[axis];
  }
  first_.assign(static_cast<std::size_t>(count), kNone);
  coordinates_.resize(static_cast<std::size_t>(count));
  for (std::int32_t cell = 0; cell < count; ++cell) {
    std::int32_t rest = cell;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      coordinates_[static_cast<std::size_t>(cell)][axis] = rest % cells[axis];
      rest /= cells[axis];
    }
  }
  build_stencils(sliding);
}

template <int Dim>
void SlidingCells<Dim>::build_stencils(bool sliding) {
  add_rows<Dim>(1, Steps<Dim>{}, sliding, neighbourhood_);
  for (const Row& row : neighbourhood_) {
    after_crossing_[0].push_back({row.steps, row.from, row.from});
    after_crossing_[1].push_back({row.steps, row.to, row.to});
    for (std::size_t axis = 1; axis < Dim; ++axis) {
      for (const int direction : {-1, 1}) {
        if (!is_new(row.steps[axis], static_cast<int>(axis), direction, sliding)) continue;
        after_crossing_[2 * axis + (direction > 0 ? 1 : 0)].push_back(row);
      }
    }
    const int up = layers(row.steps);
    if (sliding && up != 0) after_slide_.push_back({row.steps, -2 * up, -2 * up});
  }
}

template <int Dim>
int SlidingCells<Dim>::steps_between(std::int32_t from, std::int32_t to, int axis,
                                     int layers) const {
  const auto a = static_cast<std::size_t>(axis);
  int difference = coordinates(to)[a] - coordinates(from)[a];
  if (closed_axis_ == axis) return difference;
  if (axis == 0) difference += layers * whole_slide_;
  const int half = cells_[a] / 2;
  return modulo(difference + half, cells_[a]) - half;
}

template <int Dim>
void SlidingCells<Dim>::insert(std::int32_t sphere, std::int32_t cell) {
  std::int32_t& head = first_[static_cast<std::size_t>(cell)];
  next_[static_cast<std::size_t>(sphere)] = head;
  prev_[static_cast<std::size_t>(sphere)] = kNone;
  if (head != kNone) prev_[static_cast<std::size_t>(head)] = sphere;
  head = sphere;
}

template <int Dim>
void SlidingCells<Dim>::remove(std::int32_t sphere, std::int32_t cell) {
  const std::int32_t next = next_[static_cast<std::size_t>(sphere)];
  const std::int32_t prev = prev_[static_cast<std::size_t>(sphere)];
  (prev == kNone ? first_[static_cast<std::size_t>(cell)] : next_[static_cast<std::size_t>(prev)]) =
      next;
  if (next != kNone) prev_[static_cast<std::size_t>(next)] = prev;
}

template <int Dim>
void SlidingCells<Dim>::slide_by_one_cell() {
  whole_slide_ = (whole_slide_ + 1) % cells_[0];
}

#define ZENOSPHERE_INSTANTIATE(Dim) template class SlidingCells<Dim>;
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
