#include "export/cell.hpp"

#include <fmt/format.h>

#include <cmath>

#include "model/errors.hpp"
#include "model/offset.hpp"

namespace zenosphere {

double Cell::leaning_x(double x, double y) const {
  if (tilt == 0) return x;
  const double left = tilt * (y / sides[1]);
  return x - sides[0] * std::floor((x - left) / sides[0]);
}

Cell cell_of(const Snapshot& snapshot, int dimension, std::optional<int> closed,
             const std::filesystem::path& path) {
  Cell cell{.origin = {0, -0.5, -0.5}, .sides = {1, 1, 1}};
  const auto axes = static_cast<std::size_t>(dimension);
  for (std::size_t row = 0; row < axes; ++row) {
    for (std::size_t column = 0; column < axes; ++column) {
      const double edge = snapshot.box_edges[row * axes + column];
      const bool is_offset = row == 1 && column == 0;
      const bool is_right =
          std::isfinite(edge) && (row == column ? edge > 0 : is_offset || edge == 0);
      if (is_right) continue;
      throw InputError(
          fmt::format("{}: box edge {}{} = {} at collision {} (no box of a run has "
                      "that); it is damaged",
                      path.string(), "xyz"[row], "xyz"[column], edge, snapshot.step));
    }
    cell.origin[row] = 0;
    cell.sides[row] = snapshot.box_edges[row * axes + row];
    cell.periodic[row] = closed != static_cast<int>(row);
  }
  if (axes > 1) cell.tilt = reduced_offset(snapshot.box_edges[axes], cell.sides[0]);
  return cell;
}

}  // namespace zenosphere
