#include "case/case_cells.hpp"

#include <algorithm>
#include <cassert>
#include <functional>
#include <numeric>
#include <vector>

#include "case/case_box.hpp"
#include "engine/list_range.hpp"
#include "engine/reference_cells.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

double cell_width_of(const Case& values) {
  const std::vector<double> sides = box_sides(values);
  const double largest = values.system.sizes.largest;
  const Sizes sizes{largest, values.system.sizes.mean};
  const auto& pull = values.gravity.acceleration;
  const bool is_straight = std::all_of(pull.begin(), pull.end(), [](double a) { return a == 0; });
  const double width = fitting_cell_width({sides, values.system.spheres, sizes, is_straight});
  double narrowest = width;
  for (std::size_t axis = 0; axis < sides.size(); ++axis) {
    const bool is_closed = closed_axis(values) == static_cast<int>(axis);
    if (!is_closed) narrowest = std::min(narrowest, sides[axis] / 2);  // two cells at least
  }
  // Of (narrowest - largest) / 2, the radius of a ball, four grains are lost: at most half of it.
  constexpr double most_in_grains = ReferenceCells::grains_a_cell / 16.0;
  return std::min(width, std::max(most_in_grains * (narrowest - largest), narrowest));
}

template <int Dim, class Real>
ShearBox<Dim, Real> box_of(const Case& values) {
  const std::vector<double> sides = box_sides(values);
  assert(sides.size() == Dim);
  const bool is_given = !values.system.sides.empty();
  Vec<Dim, Real> real_sides;
  for (int axis = 0; axis < Dim; ++axis) {
    const double side = sides[static_cast<std::size_t>(axis)];
    real_sides[axis] = is_given ? from_decimal<Real>(side) : Real(side);
  }
  const double shear_rate = values.drive.kind == DriveKind::shear ? values.drive.shear_rate : 0;
  const double width = cell_width_of(values);
  return {real_sides, from_decimal<Real>(shear_rate), Real(width), closed_axis(values)};
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) \
  template ShearBox<Dim, Real> box_of<Dim, Real>(const Case&);
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
