#pragma once

#include <string>

#include "io/case.hpp"
#include "model/shear_box.hpp"

namespace zenosphere {

/// The cubic box of a case, cut into cells.
///
/// A dilute box gets wider cells, about two for each sphere, which keeps memory and crossings in
/// bounds. Throws std::invalid_argument where the box is too narrow; no checked case is.
template <int Dim>
ShearBox<Dim, double> box_of(const Case& values);

/// What follows exactly from a case, as aligned lines for people: box, density, cells, start,
/// shear, size of the output.
std::string derived_text(const Case& values);

}  // namespace zenosphere
