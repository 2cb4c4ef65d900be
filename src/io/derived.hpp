#pragma once

#include <string>

#include "io/case.hpp"
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

/// What follows exactly from a case, as aligned lines for people: box, density, cells, start,
/// shear, size of the output.
///
/// Throws InputError, as given_start does, where positions or velocities that the case gives are
/// wrong.
std::string derived_text(const Case& values);

}  // namespace zenosphere
