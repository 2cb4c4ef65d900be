#pragma once

#include <optional>
#include <vector>

#include "case/case.hpp"

namespace zenosphere {

/// Sides of the box of a case, D of them [diameters]: those that it gives, or those in which the
/// spheres fill the fraction that it gives, side x / each other side being the aspect ratio.
///
/// Made of IEEE operations only, so that they are the same on every machine.
std::vector<double> box_sides(const Case& values);

/// Side of the cube (square, line) that is as large as the box, diameters.
double mean_side(const Case& values);

/// Volume (area, length) of the spheres / that of the box.
double filled_fraction(const Case& values);

/// The axis that ends at walls, from 0, or nothing where the box is periodic along all.
std::optional<int> closed_axis(const Case& values);

/// The letter of an axis: x, y or z.
char axis_letter(int axis);

}  // namespace zenosphere
