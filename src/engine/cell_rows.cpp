#include "engine/cell_rows.hpp"

#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim>
CellRows<Dim>::CellRows(const Steps<Dim>& cells) : cells_(cells) {
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    strides_[axis] = count_;
    count_ *= axis == 0 ? cells[axis] + repeated : cells[axis];
    // Along x layers may have slid by a box, and images be displaced by half a box.
    const int beyond = axis == 0 ? 2 * cells[axis] : 1;
    before_[axis] = beyond;
    for (int coordinate = -beyond; coordinate < cells[axis] + beyond; ++coordinate) {
      Steps<Dim> periods{};
      int inside = coordinate;
      for (; inside < 0; inside += cells[axis]) --periods[axis];
      for (; inside >= cells[axis]; inside -= cells[axis]) ++periods[axis];
      // The image of the sphere itself is counted once, along x.
      const std::int32_t itself = axis == 0 ? 0 : PeriodicImage().code();
      const auto code = static_cast<std::uint32_t>(PeriodicImage(periods, 0).code() - itself);
      const std::uint64_t seen = code << Neighbour::sphere_bits;
      parts_[axis].push_back({(seen << 32) + static_cast<std::uint64_t>(inside * strides_[axis])});
    }
  }
}

#define ZENOSPHERE_INSTANTIATE(Dim) template class CellRows<Dim>;
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
