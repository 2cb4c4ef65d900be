#pragma once

#include "case/case.hpp"
#include "model/shear_box.hpp"

namespace zenosphere {

/// The box of a case in the precision of Real, cut into cells; closed along the axis of its walls.
///
/// Cells fit the number of spheres (fitting_cell_width()). Throws std::invalid_argument where the
/// box is too narrow; no checked case is.
template <int Dim, class Real>
ShearBox<Dim, Real> box_of(const Case& values);

/// Width that the cells of the box of a case should have, diameters: what fits the number of
/// spheres, or less where a side is much shorter than the others. Places within cells are told in
/// grains of the widest, which must be fine beside the narrowest.
double cell_width_of(const Case& values);

}  // namespace zenosphere
