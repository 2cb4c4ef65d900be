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

/// All combinations of -1, 0, 1 along the axes from `axis` on, x last.
template <int Dim>
void add_rows(int axis, Steps<Dim> steps, bool sliding, std::vector<Steps<Dim>>& stencil) {
  if (axis == Dim) {
    const Columns reach = columns(SlidingCells<Dim>::layers(steps), sliding);
    for (steps[0] = reach.from; steps[0] <= reach.to; ++steps[0]) stencil.push_back(steps);
    return;
  }
  for (const int step : {-1, 0, 1}) {
    steps[static_cast<std::size_t>(axis)] = step;
    add_rows<Dim>(axis + 1, steps, sliding, stencil);
  }
}

/// Whether `steps` lies at the rim that a sphere sees for the first time after a crossing.
///
/// Along the gradient the far row is new, and of the row just left, which was three wide, the
/// fourth cell: testing that row again is harmless.
template <int Dim>
bool is_new(const Steps<Dim>& steps, int axis, int direction, bool sliding) {
  const int step = steps[static_cast<std::size_t>(axis)];
  if (axis == 0) {
    const Columns reach = columns(SlidingCells<Dim>::layers(steps), sliding);
    return step == (direction > 0 ? reach.to : reach.from);
  }
  return step == direction || (sliding && axis == 1 && step == -direction);
}

}  // namespace

template <int Dim>
SlidingCells<Dim>::SlidingCells(const Steps<Dim>& cells, bool sliding, std::int32_t spheres)
    : cells_(cells),
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
  for (int axis = 0; axis < Dim; ++axis) {
    for (const int direction : {-1, 1}) {
      auto& stencil = after_crossing_[static_cast<std::size_t>(2 * axis + (direction > 0 ? 1 : 0))];
      for (const auto& steps : neighbourhood_) {
        if (is_new<Dim>(steps, axis, direction, sliding)) stencil.push_back(steps);
      }
    }
  }
  for (const auto& steps : neighbourhood_) {
    const int up = layers(steps);
    if (sliding && up != 0 && steps[0] == -2 * up) after_slide_.push_back(steps);
  }
}

template <int Dim>
int SlidingCells<Dim>::steps_between(std::int32_t from, std::int32_t to, int axis,
                                     int layers) const {
  const auto a = static_cast<std::size_t>(axis);
  int difference = coordinates(to)[a] - coordinates(from)[a];
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

template class SlidingCells<3>;

}  // namespace zenosphere
